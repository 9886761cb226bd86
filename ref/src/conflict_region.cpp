/// The conflict region of a point, by breadth-first search over lifts (Section 4.2).
#include <algorithm>

#include "flatdt/ref/periodic_delaunay.hpp"

namespace flatdt::ref {

template <int D>
bool PeriodicDelaunay<D>::in_conflict(CellId c, const OrbitPoint& seen) const {
  // Coordinates decide nearly always: the lifts are made only where they do not.
  const auto sign = setting_.predicates->quick_insphere(complex_.base_coordinates(c),
                                                        setting_.table->apply(seen.g, query_));
  if (sign) return *sign == Sign::positive;
  return setting_.predicates->conflict_sos(complex_.base_lift(c), complex_.lift(seen));
}

template <int D>
void PeriodicDelaunay<D>::add_boundary_facet(const Location& inside, std::uint32_t facet,
                                             const Element& lift) {
  const GroupTable& table = *setting_.table;
  const auto& cell = complex_.cell(inside.cell);
  BoundaryFacet b;
  b.outside = cell.neighbour[facet];
  b.outside_lift = lift;
  b.hole = facet;
  b.vertex = cell.vertex;
  b.offset.fill(lift);
  if (!complex_.has_no_elements(inside.cell)) {
    b.outside_lift = table.multiply(lift, complex_.gluing(inside.cell, facet));
    for (std::size_t j = 0; j <= D; ++j) b.offset[j] = table.multiply(lift, complex_.offset(inside.cell, j));
  }
  b.outside_facet = complex_.mirror_facet(inside.cell, facet);
  // The base lift is positively oriented; under a reversing element two vertices change places.
  if (table.reverses_orientation(lift)) {
    const std::size_t j = facet == 0 ? 1 : 0;
    const std::size_t k = facet == 2 || j == 2 ? 1 : 2;
    std::swap(b.vertex[j], b.vertex[k]);
    std::swap(b.offset[j], b.offset[k]);
  }
  boundary_.push_back(b);
}

template <int D>
const typename PeriodicDelaunay<D>::Visit* PeriodicDelaunay<D>::find_visit(const Location& where) const {
  for (std::uint32_t v = last_visit(where.cell); v != kNoVisit; v = visits_[v].previous)
    if (visits_[v].seen == where.seen) return &visits_[v];
  return nullptr;
}

template <int D>
void PeriodicDelaunay<D>::record_visit(const Location& where, bool conflict) {
  if (2 * visits_.size() >= visit_table_.size()) grow_visit_table();
  VisitEntry& entry = visit_table_[visit_slot(where.cell)];
  const std::uint32_t previous = entry.search == search_ ? entry.visit : kNoVisit;
  if (previous != kNoVisit) ++repeated_visits_;
  for (std::uint32_t v = previous; v != kNoVisit && !meets_own_copies_; v = visits_[v].previous)
    meets_own_copies_ = conflict || visits_[v].conflict;
  entry = {search_, static_cast<std::uint32_t>(visits_.size())};
  visits_.push_back({where.cell, where.seen, conflict, previous});
}

template <int D>
void PeriodicDelaunay<D>::begin_search() {
  visits_.clear();
  if (++search_ != 0) return;
  std::fill(visit_table_.begin(), visit_table_.end(), VisitEntry{});  // once in 2^32 searches
  search_ = 1;
}

template <int D>
void PeriodicDelaunay<D>::grow_visit_table() {
  visit_table_.assign(2 * visit_table_.size(), VisitEntry{});
  for (std::uint32_t v = 0; v < visits_.size(); ++v) visit_table_[visit_slot(visits_[v].cell)] = {search_, v};
}

/// Bounded: the search meets the lifts of cells in the region and next to it; an empty ball has radius at
/// most the covering radius of one orbit, so these are finitely many. Without covers it gives up (false) when
/// it has met many further lifts of cells that it had met before, as happens on long lattices; fewer suffice
/// where the search before was given up, for then most are: either way leads to the same cells. (Rejected: a
/// bound on all lifts that grows with the number of cells. With a cluster of 4,000 points and a gap of 10^5
/// periods each insertion into the gap met 10^5 lifts of few cells.)
template <int D>
bool PeriodicDelaunay<D>::collect_conflicts(const OrbitPoint& q, const Location& at) {
  constexpr std::size_t kLessAfterGivingUp = 8;
  const GroupTable& table = *setting_.table;
  begin_search();
  query_ = complex_.approximate(q.site);
  region_.clear();
  boundary_.clear();
  meets_own_copies_ = false;
  repeated_visits_ = 0;
  ensure(in_conflict(at.cell, {q.site, at.seen}), "a point in the closure of a cell is in conflict with it");
  record_visit(at, true);
  region_.push_back(at);
  const auto is_too_large = [this] {
    return insertion_ == Insertion::without_covers &&
           (setting_.region_limit == 0 || repeated_visits_ > region_limit_);
  };
  for (std::size_t i = 0; i < region_.size(); ++i) {
    const Location here = region_[i];
    if (is_too_large()) {
      region_limit_ = setting_.region_limit / kLessAfterGivingUp;
      return false;
    }
    const Element lift = table.multiply(q.g, table.inverse(here.seen));
    for (std::uint32_t k = 0; k <= D; ++k) {
      const auto& cell = complex_.cell(here.cell);
      Location there{cell.neighbour[k], here.seen};
      if (!complex_.has_no_elements(here.cell))
        there.seen = table.multiply(table.inverse(complex_.gluing(here.cell, k)), here.seen);
      const Visit* const known = find_visit(there);
      const bool conflict =
          known != nullptr ? known->conflict : in_conflict(there.cell, {q.site, there.seen});
      if (known == nullptr) {
        record_visit(there, conflict);
        if (conflict) region_.push_back(there);
      }
      if (!conflict) add_boundary_facet(here, k, lift);
    }
  }
  region_limit_ = setting_.region_limit;
  return true;
}

template bool PeriodicDelaunay<2>::collect_conflicts(const OrbitPoint&, const Location&);
template bool PeriodicDelaunay<3>::collect_conflicts(const OrbitPoint&, const Location&);
template bool PeriodicDelaunay<2>::in_conflict(CellId, const OrbitPoint&) const;
template bool PeriodicDelaunay<3>::in_conflict(CellId, const OrbitPoint&) const;
template void PeriodicDelaunay<2>::add_boundary_facet(const Location&, std::uint32_t, const Element&);
template void PeriodicDelaunay<3>::add_boundary_facet(const Location&, std::uint32_t, const Element&);
template void PeriodicDelaunay<2>::record_visit(const Location&, bool);
template void PeriodicDelaunay<3>::record_visit(const Location&, bool);
template void PeriodicDelaunay<2>::begin_search();
template void PeriodicDelaunay<3>::begin_search();
template void PeriodicDelaunay<2>::grow_visit_table();
template void PeriodicDelaunay<3>::grow_visit_table();
template const PeriodicDelaunay<2>::Visit* PeriodicDelaunay<2>::find_visit(const Location&) const;
template const PeriodicDelaunay<3>::Visit* PeriodicDelaunay<3>::find_visit(const Location&) const;

}  // namespace flatdt::ref
