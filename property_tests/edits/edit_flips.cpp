/// Flips: wrong where the points are not on one sphere, a matter of taste where they are.
#include <set>

#include "flip.hpp"

namespace flatdt::edits {

using Name = checker::ConditionName;

namespace {

enum class Shape { facet, edge, quadrilateral, quadrilateral_filled };

/// The facets to try, in random order: those between cells on one sphere, or all.
std::vector<std::pair<std::size_t, std::size_t>> facets(const Base& base, Random& random, bool ties) {
  std::vector<std::pair<std::size_t, std::size_t>> all;
  if (ties) {
    all = base.ties();
  } else {
    for (std::size_t c = 0; c < base.cell_count(); ++c)
      for (std::size_t i = 0; i < base.corners(); ++i) all.emplace_back(c, i);
  }
  random.shuffle(all);
  return all;
}

/// All flips of a shape that exist, ties only or all, in random order, until one is accepted.
template <class Accept>
std::optional<Files> first_flip(const Base& base, Random& random, Shape shape, bool ties,
                                const Accept& accept) {
  if (base.dimension() == 2 && shape != Shape::facet) return std::nullopt;
  Draft draft(base);
  for (const auto& [c, i] : facets(base, random, ties)) {
    std::vector<std::optional<Flip>> found;
    if (shape == Shape::facet) found.push_back(facet_flip(base, draft, c, i));
    if (shape == Shape::quadrilateral || shape == Shape::quadrilateral_filled)
      found.push_back(quadrilateral_flip(base, draft, c, i, shape == Shape::quadrilateral_filled));
    if (shape == Shape::edge)
      for (std::size_t j = 0; j < base.corners(); ++j)
        if (j != i) found.push_back(edge_flip(base, draft, c, i, j));
    for (const std::optional<Flip>& flip : found) {
      if (!flip || !accept(*flip)) continue;
      apply(*flip, draft);
      return draft.files();
    }
  }
  return std::nullopt;
}

bool closes(const Base& base, const Flip& flip) {
  return flip.adds_edge && base.closes_short_cycle(flip.from, flip.to);
}

auto wrong_flip(Shape shape, int dimension) {
  return [shape, dimension](const Base& base, Random& random) -> std::optional<Files> {
    if (base.dimension() != dimension) return std::nullopt;
    return first_flip(base, random, shape, false, [](const Flip& flip) { return !flip.tie; });
  };
}

auto tie_flip(Shape shape, int dimension, bool in_cover) {
  return [shape, dimension, in_cover](const Base& base, Random& random) -> std::optional<Files> {
    if (base.dimension() != dimension || base.on_manifold() == in_cover) return std::nullopt;
    return first_flip(base, random, shape, true,
                      [&](const Flip& flip) { return flip.tie && !closes(base, flip); });
  };
}

/// The new edge is no loop: an edge from u to h u, the diagonal of cells on a vertex v, would make
/// 2-cycles of the edges from v to u and to h u.
std::optional<Files> closing_flip(const Base& base, Random& random) {
  const auto closing = [&](const Flip& flip) { return flip.tie && closes(base, flip); };
  std::optional<Files> files = first_flip(base, random, Shape::facet, true, closing);
  return files ? files : first_flip(base, random, Shape::quadrilateral, true, closing);
}

std::optional<Files> half_flip(const Base& base, Random& random) {
  return first_flip(base, random, Shape::quadrilateral_filled, false, [](const Flip&) { return true; });
}

/// Ties decided anew wherever the flips do not meet; edges between points that no edge joined before.
std::optional<Files> many_tie_flips(const Base& base, Random& random) {
  Draft draft(base);
  std::set<std::size_t> touched;
  std::vector<std::size_t> gone;
  std::vector<FileCell> come;
  std::set<std::set<ref::Vector>> added;
  std::size_t flips = 0;
  for (const auto& [c, i] : facets(base, random, true)) {
    std::optional<Flip> flip = facet_flip(base, draft, c, i);
    if (!flip && base.dimension() == 3) flip = quadrilateral_flip(base, draft, c, i, false);
    if (!flip || !flip->tie || closes(base, *flip)) continue;
    bool free = true;
    for (const std::size_t cell : flip->gone) free = free && touched.count(cell) == 0;
    if (!free) continue;
    const CrystalGroup& h = base.subgroup();
    if (!added.insert({h.canonical(flip->from).point, h.canonical(flip->to).point}).second) continue;
    touched.insert(flip->gone.begin(), flip->gone.end());
    gone.insert(gone.end(), flip->gone.begin(), flip->gone.end());
    come.insert(come.end(), flip->come.begin(), flip->come.end());
    ++flips;
  }
  if (flips < 2) return std::nullopt;
  draft.remove_cells(gone);
  for (const FileCell& cell : come) draft.cells().push_back(cell);
  return draft.files();
}

}  // namespace

std::vector<Kind> flip_kinds() {
  const Expectation wrong = breaks({Name::delaunay_empty}, {},
                                   {Name::vertices_complete, Name::cells_nondegenerate, Name::facets_paired,
                                    Name::facets_opposite, Name::volume_exact});
  const Expectation cycle =
      breaks({Name::skeleton_no_2_cycle, Name::complex_intersection}, {},
             {Name::vertices_complete, Name::cells_nondegenerate, Name::facets_paired, Name::facets_opposite,
              Name::volume_exact, Name::delaunay_empty, Name::links_spheres});
  const Expectation flat =
      breaks({Name::cells_nondegenerate}, {},
             {Name::vertices_complete, Name::facets_paired, Name::facets_opposite, Name::volume_exact});
  const std::string_view upper = "the new cells are upper faces of the lifted points (flip.hpp)";
  const std::string_view equal = "all points are on one empty sphere, and no loop or 2-cycle arises";
  return {
      {"flip 2-2", upper, wrong, wrong_flip(Shape::facet, 2)},
      {"flip 2-3", upper, wrong, wrong_flip(Shape::facet, 3)},
      {"flip 3-2", upper, wrong, wrong_flip(Shape::edge, 3)},
      {"flip 4-4", upper, wrong, wrong_flip(Shape::quadrilateral, 3)},
      {"flat cell between two cuts of a quadrilateral", "it has volume 0, the rest is a tiling", flat,
       half_flip},
      {"tie flipped, making a short cycle", "the ends of the new edge are joined already", cycle,
       closing_flip},
      {"tie flipped 2-2", equal, keeps(), tie_flip(Shape::facet, 2, false)},
      {"tie flipped 2-3", equal, keeps(), tie_flip(Shape::facet, 3, false)},
      {"tie flipped 3-2", equal, keeps(), tie_flip(Shape::edge, 3, false)},
      {"tie flipped 4-4", equal, keeps(), tie_flip(Shape::quadrilateral, 3, false)},
      {"tie flipped in one sheet, 2-2", equal, keeps(), tie_flip(Shape::facet, 2, true)},
      {"tie flipped in one sheet, 2-3", equal, keeps(), tie_flip(Shape::facet, 3, true)},
      {"tie flipped in one sheet, 3-2", equal, keeps(), tie_flip(Shape::edge, 3, true)},
      {"tie flipped in one sheet, 4-4", equal, keeps(), tie_flip(Shape::quadrilateral, 3, true)},
      {"many ties flipped", equal, keeps(), many_tie_flips},
  };
}

}  // namespace flatdt::edits
