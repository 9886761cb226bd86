#include "respace.hpp"

#include <algorithm>

#include "draft.hpp"

namespace flatdt::edits {

using ref::Isometry;
using ref::Rational;
using ref::Vector;

namespace {

constexpr std::size_t kMostSheets = 48;
constexpr std::size_t kCandidates = 80;

/// One lift of every cell modulo G; nothing if the cells modulo H are not all images of these under G.
std::optional<std::vector<FileCell>> cells_modulo(const Case& c, const CrystalGroup& g,
                                                  const CrystalGroup& h) {
  const std::size_t sheets = g.right_cosets(h).size();
  std::map<FaceKey, std::size_t> count;
  std::vector<FileCell> chosen;
  for (const FileCell& cell : c.triangulation.cells)
    if (++count[face_key(g, positions(c, cell))] == 1) chosen.push_back(cell);
  const bool invariant =
      std::all_of(count.begin(), count.end(), [&](const auto& item) { return item.second == sheets; });
  return invariant ? std::optional(chosen) : std::nullopt;
}

/// No loop and no two edges with the same ends modulo H.
bool is_simplicial(const Case& c, const CrystalGroup& h) {
  std::map<std::pair<Vector, Vector>, FaceKey> edges;
  for (const FileCell& cell : c.triangulation.cells) {
    const std::vector<Vector> points = positions(c, cell);
    std::vector<Vector> classes;
    for (const Vector& x : points) classes.push_back(h.canonical(x).point);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (classes[i] == classes[j]) return false;
        const auto [known, fresh] = edges.emplace(std::minmax(classes[i], classes[j]), FaceKey{});
        const FaceKey key = face_key(h, {points[i], points[j]});
        if (fresh)
          known->second = key;
        else if (known->second != key)
          return false;
      }
  }
  return true;
}

Case unfolded(const Case& c, const std::vector<FileCell>& modulo_g, const std::vector<Isometry>& cosets,
              const std::vector<Isometry>& generators) {
  Draft draft(c);
  draft.cells().clear();
  for (const FileCell& cell : modulo_g)
    for (const Isometry& f : cosets) draft.cells().push_back(draft.moved(f, cell));
  draft.triangulation().has_subgroup = true;
  draft.triangulation().subgroup = generators;
  return draft.data();
}

/// The group of the space that is triangulated.
CrystalGroup group_of_space(const Case& c) {
  return {c.instance.gram, c.triangulation.has_subgroup ? c.triangulation.subgroup : c.instance.generators};
}

}  // namespace

std::optional<Case> over_subgroup(const Case& valid, const std::vector<Isometry>& generators) {
  const CrystalGroup g(valid.instance.gram, valid.instance.generators);
  const std::optional<std::vector<FileCell>> cells = cells_modulo(valid, g, group_of_space(valid));
  if (!cells) return std::nullopt;
  const CrystalGroup h(valid.instance.gram, generators);
  Case found = unfolded(valid, *cells, g.right_cosets(h), generators);
  return is_simplicial(found, h) ? std::optional(std::move(found)) : std::nullopt;
}

std::optional<Case> over_small_subgroup(const Case& valid, Random& random) {
  const CrystalGroup g(valid.instance.gram, valid.instance.generators);
  const std::optional<std::vector<FileCell>> cells = cells_modulo(valid, g, group_of_space(valid));
  if (!cells) return std::nullopt;
  std::vector<std::pair<std::size_t, std::vector<Isometry>>> candidates;
  for (std::size_t count = 0; count < kCandidates; ++count) {
    std::vector<Isometry> generators;
    if (random.below(3) > 0) generators.push_back(g.element(random, 1));
    // A random sublattice in Hermite normal form.
    for (int j = 0; j < g.lattice().dimension(); ++j) {
      Vector v = Rational(random.between(1, 5)) * g.lattice().column(j);
      for (int k = j + 1; k < g.lattice().dimension(); ++k)
        v = v + Rational(random.between(0, 3)) * g.lattice().column(k);
      generators.push_back(Isometry::translate(v));
    }
    const CrystalGroup candidate(valid.instance.gram, generators);
    candidates.emplace_back(g.index_of(candidate), generators);
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [index, generators] : candidates) {
    if (index > kMostSheets) break;
    const CrystalGroup candidate(valid.instance.gram, generators);
    const Case found = unfolded(valid, *cells, g.right_cosets(candidate), generators);
    if (is_simplicial(found, candidate)) return found;
  }
  return std::nullopt;
}

Case as_manifold(const Case& valid) {
  const CrystalGroup g(valid.instance.gram, valid.instance.generators);
  const CrystalGroup h(valid.instance.gram, valid.triangulation.subgroup);
  const std::vector<Isometry> cosets = g.right_cosets(h);
  Draft draft(valid);
  draft.instance().name.reset();
  draft.set_generators(valid.triangulation.subgroup);
  draft.instance().points.clear();
  std::map<Vector, std::pair<std::uint32_t, Isometry>>
      lifts;  // canonical point: its index, and what takes it there
  for (const Vector& p : valid.instance.points)
    for (const Isometry& f : cosets) {
      const CrystalGroup::Canonical canonical = h.canonical(f * p);
      lifts.emplace(canonical.point,
                    std::pair(static_cast<std::uint32_t>(draft.instance().points.size()), canonical.mover));
      draft.instance().points.push_back(f * p);
    }
  draft.triangulation().has_subgroup = false;
  draft.triangulation().subgroup.clear();
  draft.triangulation().elements = {Isometry::identity(valid.instance.dimension)};
  for (std::size_t c = 0; c < draft.cells().size(); ++c)
    for (std::size_t i = 0; i <= static_cast<std::size_t>(valid.instance.dimension); ++i) {
      const CrystalGroup::Canonical canonical = h.canonical(position(valid, valid.triangulation.cells[c][i]));
      const auto& [index, mover] = lifts.at(canonical.point);
      draft.cells()[c][i] = {index, draft.index_of(canonical.mover.inverse() * mover)};
    }
  return draft.data();
}

}  // namespace flatdt::edits
