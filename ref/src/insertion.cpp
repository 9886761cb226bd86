/// Starring of the hole (Section 4.2), the list L and the conversion to the manifold (Section 4.1).
#include <algorithm>
#include <bit>

#include "flatdt/ref/periodic_delaunay.hpp"
#include "long_lattice_star.hpp"

namespace flatdt::ref {

template <int D>
PeriodicDelaunay<D>::PeriodicDelaunay(const Setting<D>& setting, const Subgroup& subgroup,
                                      Insertion insertion)
    : setting_(setting),
      insertion_(insertion),
      complex_(*setting.table, *setting.sites, subgroup),
      by_rank_(insertion == Insertion::without_covers && subgroup.is_whole() &&
               !setting.order->invariance_group().is_whole()),
      visit_table_(128),
      region_limit_(setting.region_limit) {}

template <int D>
void PeriodicDelaunay<D>::start(SiteId site, const std::vector<CellPoints<D>>& cells) {
  const Subgroup& invariance = setting_.order->invariance_group();
  complex_.add_site(site);
  if (by_rank_) {
    const auto quotient = cells_modulo<D>(*setting_.table, complex_.subgroup(), cells, invariance.index());
    if (quotient) complex_.assemble(*quotient, *setting_.predicates);
    needs_smaller_group_ = !quotient.has_value();
    ties_of_first_orbit_ = setting_.predicates->ties_within_orbits();
    return;
  }
  complex_.assemble(unfold<D>(*setting_.table, invariance, complex_.subgroup(), cells), *setting_.predicates);
  for (std::uint32_t c = 0; c < complex_.cell_slots(); ++c) note_new(CellId{c});
}

template <int D>
void PeriodicDelaunay<D>::start(SiteId site, const QuotientComplex<D>& of_one_orbit) {
  ensure(insertion_ == Insertion::without_covers, "cells of a cover go to the list L");
  complex_.add_site(site);
  complex_.assume_cells(of_one_orbit);
}

template <int D>
void PeriodicDelaunay<D>::note_new(CellId c) {
  // On the manifold Corollary 9 has been met for good, and without covers nothing waits for it.
  if (is_on_manifold() || insertion_ == Insertion::without_covers) return;
  large_.resize(complex_.cell_slots(), false);
  large_[index_of(c)] = setting_.circumradius->is_large(complex_.base_lift(c));
  if (large_[index_of(c)]) ++large_cells_;
}

template <int D>
void PeriodicDelaunay<D>::note_deleted(CellId c) {
  if (!is_large(c)) return;
  --large_cells_;
  large_[index_of(c)] = false;
}

/// The two cells of a ridge of the boundary, the first of which waits in the table, become neighbours. Both
/// are given in coordinates where q is at its base position: the gluing is the identity.
template <int D>
void PeriodicDelaunay<D>::glue_at_ridge(const Ridge& ridge) {
  std::uint64_t hash = 0;
  for (const auto& [v, offset] : ridge.key)
    hash = (hash ^ index_of(v) ^ offset.packed()) * 0x9e3779b97f4a7c15U;
  const std::size_t mask = ridge_table_.size() - 1;
  // Bounded: the table is at most half full.
  for (std::size_t slot = hash >> 32U & mask;; slot = (slot + 1) & mask) {
    const std::uint32_t other = ridge_table_[slot];
    if (other == kNoRidge) {
      ridge_table_[slot] = static_cast<std::uint32_t>(ridges_.size());
      ridges_.push_back(ridge);
      return;
    }
    Ridge& waiting = ridges_[other];
    if (waiting.key != ridge.key) continue;
    ensure(waiting.cell != kNoCell, "the boundary of the hole is a closed manifold");
    complex_.set_neighbour(waiting.cell, waiting.facet, ridge.cell, Element{});
    complex_.set_neighbour(ridge.cell, ridge.facet, waiting.cell, Element{});
    waiting.cell = kNoCell;
    ++glued_ridges_;
    return;
  }
}

template <int D>
void PeriodicDelaunay<D>::star_hole(VertexId q) {
  for (const Location& inside : region_) {
    note_deleted(inside.cell);
    complex_.delete_cell(inside.cell);
  }
  ridges_.clear();
  glued_ridges_ = 0;
  // Each ridge is in two facets of D: half as many entries as facets times D.
  ridge_table_.assign(std::bit_ceil(boundary_.size() * D), kNoRidge);
  for (const BoundaryFacet& b : boundary_) {
    ensure(complex_.cell(b.outside).is_alive(),
           "the star of a vertex does not touch its own copies along a facet");
    const CellId c = complex_.new_cell();
    for (std::size_t k = 0; k <= D; ++k) {
      const VertexId v = k == b.hole ? q : b.vertex[k];
      complex_.set_vertex(c, k, v, k == b.hole ? Element{} : b.offset[k]);
      complex_.vertex(v).cell = c;
    }
    complex_.set_neighbour(c, b.hole, b.outside, b.outside_lift);
    complex_.set_neighbour(b.outside, b.outside_facet, c, setting_.table->inverse(b.outside_lift));
    for (std::uint32_t j = 0; j <= D; ++j) {
      if (j == b.hole) continue;
      Ridge ridge{{}, c, j};
      for (std::size_t k = 0, i = 0; k <= D; ++k)
        if (k != j && k != b.hole) ridge.key[i++] = {b.vertex[k], b.offset[k]};
      if constexpr (D == 3)
        if (ridge.key[1] < ridge.key[0]) std::swap(ridge.key[0], ridge.key[1]);
      glue_at_ridge(ridge);
    }
    note_new(c);
  }
  ensure(glued_ridges_ == ridges_.size(), "the boundary of the hole is closed");
}

template <int D>
void PeriodicDelaunay<D>::insert(SiteId site, std::uint32_t rep, const Location& at) {
  if (needs_smaller_group_) return;
  const OrbitPoint q{site, complex_.subgroup().representative(rep)};
  const bool found_all = collect_conflicts(q, at);
  // The star of q among its own copies on a long lattice of boxes, as all of them are here, has such ties.
  if (met_undecided_tie() || (by_rank_ && !found_all)) {
    needs_smaller_group_ = true;
    return;
  }
  if (!found_all) {
    const LongLatticeStar<D> star(setting_, complex_, q, at);
    replace_by_star(star.cells(), star.conflicts());
    return;
  }
  if (!meets_own_copies_) {
    star_hole(complex_.vertex_of(site, rep));
    return;
  }
  // In a safe cover q and a copy of it cannot share a neighbour: that would be a 2-cycle.
  ensure(insertion_ == Insertion::without_covers, "no cell of the conflict region occurs twice modulo H");
  std::vector<CellId> removed;
  removed.reserve(region_.size());
  for (const Location& here : region_) removed.push_back(here.cell);
  const std::vector<CellPoints<D>> star = star_among_own_copies(q);
  needs_smaller_group_ = met_undecided_tie();
  if (!needs_smaller_group_) replace_by_star(star, std::move(removed));
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
    quotient.add_site(complex_.vertex(VertexId{static_cast<std::uint32_t>(i)}).site);
  quotient.assemble(*cells, *setting_.predicates);
  complex_ = std::move(quotient);
}

template class PeriodicDelaunay<2>;
template class PeriodicDelaunay<3>;

}  // namespace flatdt::ref
