/// Starring of the hole (Section 4.2), the list L and the conversion to the manifold (Section 4.1).
#include <algorithm>

#include "flatdt/ref/periodic_delaunay.hpp"
#include "long_lattice_star.hpp"

namespace flatdt::ref {

template <int D>
PeriodicDelaunay<D>::PeriodicDelaunay(const Setting<D>& setting, const Subgroup& subgroup,
                                      Insertion insertion)
    : setting_(setting), insertion_(insertion), complex_(*setting.table, *setting.sites, subgroup) {}

template <int D>
void PeriodicDelaunay<D>::start(SiteId site, const std::vector<CellPoints<D>>& cells) {
  complex_.add_site(site);
  complex_.assemble(
      unfold<D>(*setting_.table, setting_.order->invariance_group(), complex_.subgroup(), cells),
      *setting_.predicates);
  for (std::uint32_t c = 0; c < complex_.cell_slots(); ++c) note_new(CellId{c});
}

template <int D>
void PeriodicDelaunay<D>::note_new(CellId c) {
  // On the manifold Corollary 9 has been met for good, and without covers nothing waits for it.
  if (is_on_manifold() || insertion_ == Insertion::without_covers) return;
  auto& cell = complex_.cell(c);
  cell.large = setting_.circumradius->is_large(complex_.base_lift(c));
  if (cell.large) ++large_cells_;
}

template <int D>
void PeriodicDelaunay<D>::note_deleted(CellId c) {
  if (complex_.cell(c).large) --large_cells_;
  complex_.cell(c).large = false;
}

template <int D>
void PeriodicDelaunay<D>::star_hole(VertexId q) {
  for (const Location& inside : region_) {
    note_deleted(inside.cell);
    complex_.delete_cell(inside.cell);
  }
  ridges_.clear();
  for (const BoundaryFacet& b : boundary_) {
    ensure(complex_.cell(b.outside).alive,
           "the star of a vertex does not touch its own copies along a facet");
    const CellId c = complex_.new_cell();
    auto& cell = complex_.cell(c);
    cell.vertex = b.vertex;
    cell.offset = b.offset;
    cell.vertex[b.hole] = q;
    cell.offset[b.hole] = Element{};
    cell.large = false;
    cell.visit = 0;
    for (const VertexId v : cell.vertex) complex_.vertex(v).cell = c;
    cell.neighbour[b.hole] = b.outside;
    cell.gluing[b.hole] = b.outside_lift;
    auto& outside = complex_.cell(b.outside);
    outside.neighbour[b.outside_facet] = c;
    outside.gluing[b.outside_facet] = setting_.table->inverse(b.outside_lift);
    for (std::uint32_t j = 0; j <= D; ++j) {
      if (j == b.hole) continue;
      Ridge ridge{{}, c, j};
      for (std::size_t k = 0, i = 0; k <= D; ++k)
        if (k != j && k != b.hole) ridge.key[i++] = {b.vertex[k], b.offset[k]};
      if constexpr (D == 3)
        if (ridge.key[1] < ridge.key[0]) std::swap(ridge.key[0], ridge.key[1]);
      ridges_.push_back(ridge);
    }
    note_new(c);
  }
  std::sort(ridges_.begin(), ridges_.end(), [](const Ridge& a, const Ridge& b) { return a.key < b.key; });
  ensure(ridges_.size() % 2 == 0, "the boundary of the hole is closed");
  for (std::size_t i = 0; i < ridges_.size(); i += 2) {
    const Ridge& a = ridges_[i];
    const Ridge& b = ridges_[i + 1];
    ensure(a.key == b.key, "the boundary of the hole is a closed manifold");
    // Both cells are given in coordinates where q is at its base position: the gluing is the identity.
    complex_.cell(a.cell).neighbour[a.facet] = b.cell;
    complex_.cell(a.cell).gluing[a.facet] = Element{};
    complex_.cell(b.cell).neighbour[b.facet] = a.cell;
    complex_.cell(b.cell).gluing[b.facet] = Element{};
  }
}

template <int D>
void PeriodicDelaunay<D>::insert(SiteId site, std::uint32_t rep, const Location& at) {
  const OrbitPoint q{site, complex_.subgroup().representative(rep)};
  if (!collect_conflicts(q, at)) {
    const LongLatticeStar<D> star(setting_, complex_, q);
    replace_by_star(star.cells(), star.conflicts(at.cell));
    return;
  }
  if (!meets_own_copies_) {
    star_hole(complex_.vertex_of(site, rep));
    return;
  }
  // In a safe cover q and a copy of it cannot share a neighbour: that would be a 2-cycle.
  ensure(insertion_ == Insertion::without_covers, "no cell of the conflict region occurs twice modulo H");
  std::vector<CellId> removed;
  for (const Location& here : region_) removed.push_back(here.cell);
  replace_by_star(star_among_own_copies(q), std::move(removed));
}

template <int D>
void PeriodicDelaunay<D>::convert_to_manifold() {
  ensure(large_cells_ == 0 && !is_on_manifold(), "conversion follows Corollary 9");
  const Subgroup whole = Subgroup::whole(*setting_.table);
  // Empty balls are smaller than delta/2, so no tie involves two points of one orbit and the orbits' ranks
  // alone decided: the triangulation is invariant under all of G, for the didicosm too.
  const auto cells =
      cells_modulo<D>(*setting_.table, whole, complex_.all_cells(), complex_.subgroup().index());
  ensure(cells.has_value(), "the triangulation of complete orbits is invariant under the group");
  QuotientComplex<D> quotient(*setting_.table, *setting_.sites, whole);
  for (std::size_t i = 0; i < complex_.vertex_count(); i += complex_.subgroup().index())
    quotient.add_site(complex_.vertex(VertexId{static_cast<std::uint32_t>(i)}).point.site);
  quotient.assemble(*cells, *setting_.predicates);
  complex_ = std::move(quotient);
}

template class PeriodicDelaunay<2>;
template class PeriodicDelaunay<3>;

}  // namespace flatdt::ref
