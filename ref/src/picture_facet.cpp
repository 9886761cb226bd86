/// The cells that are glued at one facet.
#include <algorithm>

#include "picture_witness.hpp"

namespace flatdt::ref::picture {
namespace {

struct CanonicalFace {
  Simplex corners;  // sorted
  Isometry from;    // takes the face to these corners
};

/// The least of the images of the face that have a corner at the least point of its orbit: two faces are one
/// modulo the group iff these are equal, because the group acts freely.
CanonicalFace canonical(const PictureGroup& group, const Simplex& face) {
  std::optional<CanonicalFace> best;
  for (const Vector& corner : face) {
    const Isometry g = to_least(group, corner);
    Simplex image;
    for (const Vector& x : face) image.push_back(g * x);
    std::sort(image.begin(), image.end());
    if (!best || image < best->corners) best = CanonicalFace{std::move(image), g};
  }
  return std::move(*best);
}

}  // namespace

void add_cells_at_facet(Witness& witness, const Instance& instance, const Triangulation& triangulation,
                        const PictureGroup& group) {
  constexpr std::size_t kMost = 8, kMostCells = 5'000;
  if (triangulation.cells.size() > kMostCells) return;
  const auto mark = std::find_if(witness.marks.begin(), witness.marks.end(),
                                 [](const Mark& m) { return m.kind == Mark::Kind::face; });
  if (mark == witness.marks.end() || mark->corners.size() != static_cast<std::size_t>(instance.dimension))
    return;
  const CanonicalFace facet = canonical(group, mark->corners);
  const Isometry back = facet.from.inverse();
  std::vector<Mark> found;
  for (std::size_t c = 0; c < triangulation.cells.size() && found.size() < kMost; ++c) {
    const Simplex cell = simplex_of(instance, triangulation, c);
    for (std::size_t k = 0; k < cell.size(); ++k) {
      Simplex side = cell;
      side.erase(side.begin() + static_cast<std::ptrdiff_t>(k));
      const CanonicalFace other = canonical(group, side);
      if (other.corners != facet.corners) continue;
      Mark laid{Mark::Kind::other_cell, {}};
      for (const Vector& x : cell) laid.corners.push_back(back * (other.from * x));
      // A cell that is listed twice lies on the mark itself: it is named, not drawn again.
      const auto same = [&](const Mark& m) {
        Simplex a = m.corners, b = laid.corners;
        std::sort(a.begin(), a.end());
        std::sort(b.begin(), b.end());
        return a == b;
      };
      witness.cells.push_back(static_cast<std::uint32_t>(c));
      if (std::none_of(witness.marks.begin(), witness.marks.end(), same) &&
          std::none_of(found.begin(), found.end(), same))
        found.push_back(std::move(laid));
    }
  }
  witness.marks.insert(witness.marks.end(), found.begin(), found.end());
}

}  // namespace flatdt::ref::picture
