/// Edits of the list of cells: removed, repeated, exchanged.
///
/// Lemma (one cell). Replace exactly one cell of a valid triangulation by a simplex that is not in its
/// H-orbit: then facets.paired fails. Proof. Were it to hold, the facets of the new cell c' would be those of
/// the old one, c. The classes of the corners of c are different (the complex is simplicial), so those of c'
/// are the same, and c' can be moved to share a facet with c; let v' and v be the opposite corners, of one
/// class. For a corner u of the facet, a facet of c' with v' and u is one of c modulo H, so some h takes the
/// edge (v', u) to the only edge of c with ends in these classes: h u = u, so h = 1 and v' = v. []
#include "draft.hpp"

namespace flatdt::edits {

using Name = checker::ConditionName;

namespace {

std::optional<Files> remove_cell(const Base& base, Random& random) {
  Draft draft(base);
  draft.remove_cells({random.below(base.cell_count())});
  return draft.files();
}

std::optional<Files> remove_half(const Base& base, Random& random) {
  Draft draft(base);
  std::vector<std::size_t> order = random.order(base.cell_count());
  order.resize((order.size() + 1) / 2);
  draft.remove_cells(order);
  return draft.files();
}

std::optional<Files> remove_all(const Base& base, Random& /*random*/) {
  Draft draft(base);
  draft.cells().clear();
  return draft.files();
}

std::optional<Files> repeat_cell(const Base& base, Random& random) {
  Draft draft(base);
  draft.cells().push_back(random.choice(draft.cells()));
  return draft.files();
}

std::optional<Files> repeat_cell_other_lift(const Base& base, Random& random) {
  Draft draft(base);
  const FileCell cell = random.choice(draft.cells());
  draft.cells().push_back(draft.moved(base.subgroup().element(random, 2), cell));
  return draft.files();
}

std::optional<Files> exchange_cell(const Base& base, Random& random) {
  Draft draft(base);
  const std::vector<std::size_t> order = random.order(base.cell_count());
  draft.cells()[order[0]] = draft.moved(base.subgroup().element(random, 2), draft.cells()[order[1]]);
  return draft.files();
}

std::optional<Files> repeat_all(const Base& base, Random& random) {
  Draft draft(base);
  const bool other_lifts = random.below(2) == 1;
  const std::vector<FileCell> once = draft.cells();
  for (const FileCell& cell : once)
    draft.cells().push_back(other_lifts ? draft.moved(base.subgroup().element(random, 2), cell) : cell);
  return draft.files();
}

std::optional<Files> remove_star(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t start = random.below(base.cell_count());
  const ref::Vector centre = base.subgroup().canonical(base.cell(start)[random.below(base.corners())]).point;
  std::vector<std::size_t> star;
  for (std::size_t c = 0; c < base.cell_count(); ++c)
    for (const ref::Vector& v : base.cell(c))
      if (base.subgroup().canonical(v).point == centre) star.push_back(c);
  draft.remove_cells(star);
  return draft.files();
}

std::optional<Files> one_cell_twice(const Base& base, Random& random) {
  Draft draft(base);
  const FileCell cell = random.choice(draft.cells());
  draft.cells() = {cell, draft.moved(base.subgroup().element(random, 1), cell)};
  return draft.files();
}

std::optional<Files> fold_cell(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t c = random.below(base.cell_count());
  const std::size_t corner = random.below(base.corners());
  const Base::Neighbour& n = base.neighbour(c, corner);
  draft.cells()[c][corner] = draft.moved(n.to, file_vertex(base, n.cell, n.corner));
  return draft.files();
}

}  // namespace

std::vector<Kind> cell_kinds() {
  const Conditions count = {Name::facets_paired, Name::volume_exact};
  return {
      {"cell removed", "its facets occur once, and its volume is missing", breaks(count), remove_cell},
      {"half of the cells removed", "volume is missing", breaks({Name::volume_exact}), remove_half},
      {"all cells removed", "no cell has a vertex or a volume",
       breaks({Name::vertices_complete, Name::volume_exact}), remove_all},
      {"cell repeated", "its facets occur three times, and its volume is counted twice", breaks(count),
       repeat_cell},
      {"cell repeated, other lift", "the same: a cell is an orbit", breaks(count), repeat_cell_other_lift},
      {"cell replaced by another of the list", "lemma on one cell", breaks({Name::facets_paired}),
       exchange_cell},
      {"every cell twice", "facets occur four times, and the volume is doubled", breaks(count), repeat_all},
      {"star of a vertex removed",
       "the vertex is gone; across a facet of its link lies a cell without it, since no two cells have the "
       "same vertices",
       breaks({Name::vertices_complete, Name::facets_paired, Name::volume_exact}), remove_star},
      {"one cell twice, nothing else",
       "the double of a simplex is a sphere with d+1 vertices, while every space here has more vertices and "
       "first "
       "homology",
       breaks({Name::vertices_complete, Name::facets_opposite, Name::topology_homology}, {},
              {Name::facets_paired}),
       one_cell_twice},
      {"cell folded over a facet", "lemma on one cell: it now covers its neighbour",
       breaks({Name::facets_paired}), fold_cell},
  };
}

}  // namespace flatdt::edits
