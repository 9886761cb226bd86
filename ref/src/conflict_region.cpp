/// The conflict region of a point, by breadth-first search over lifts (Section 4.2).
#include "flatdt/ref/periodic_delaunay.hpp"

namespace flatdt::ref {

template <int D>
bool PeriodicDelaunay<D>::in_conflict(CellId c, const OrbitPoint& seen) const {
  // Coordinates decide nearly always: the lifts are made only where they do not.
  const auto sign =
      setting_.predicates->quick_insphere(complex_.base_coordinates(c), complex_.coordinates(seen));
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
  b.outside_lift = table.multiply(lift, complex_.gluing(inside.cell, facet));
  b.hole = facet;
  for (std::size_t j = 0; j <= D; ++j) {
    b.vertex[j] = cell.vertex[j];
    b.offset[j] = table.multiply(lift, complex_.offset(inside.cell, j));
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
  const std::uint32_t previous = last_visit(where.cell);
  if (previous != kNoVisit) ++repeated_visits_;
  for (std::uint32_t v = previous; v != kNoVisit && !meets_own_copies_; v = visits_[v].previous)
    meets_own_copies_ = conflict || visits_[v].conflict;
  complex_.cell(where.cell).visit = static_cast<std::uint32_t>(visits_.size());
  visits_.push_back({where.cell, where.seen, conflict, previous});
}

/// Bounded: the search meets the lifts of cells in the region and next to it; an empty ball has radius at
/// most the covering radius of one orbit, so these are finitely many. Without covers it gives up (false) when
/// it has met many further lifts of cells that it had met before, as happens on long lattices. (Rejected: a
/// bound on all lifts that grows with the number of cells. With a cluster of 4,000 points and a gap of 10^5
/// periods each insertion into the gap met 10^5 lifts of few cells.)
template <int D>
bool PeriodicDelaunay<D>::collect_conflicts(const OrbitPoint& q, const Location& at) {
  const GroupTable& table = *setting_.table;
  visits_.clear();
  region_.clear();
  boundary_.clear();
  meets_own_copies_ = false;
  repeated_visits_ = 0;
  ensure(in_conflict(at.cell, {q.site, at.seen}), "a point in the closure of a cell is in conflict with it");
  record_visit(at, true);
  region_.push_back(at);
  const auto is_too_large = [this] {
    return insertion_ == Insertion::without_covers &&
           (setting_.region_limit == 0 || repeated_visits_ > setting_.region_limit);
  };
  for (std::size_t i = 0; i < region_.size(); ++i) {
    const Location here = region_[i];
    if (is_too_large()) return false;
    const Element lift = table.multiply(q.g, table.inverse(here.seen));
    for (std::uint32_t k = 0; k <= D; ++k) {
      const auto& cell = complex_.cell(here.cell);
      const Location there{cell.neighbour[k],
                           table.multiply(table.inverse(complex_.gluing(here.cell, k)), here.seen)};
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
template const PeriodicDelaunay<2>::Visit* PeriodicDelaunay<2>::find_visit(const Location&) const;
template const PeriodicDelaunay<3>::Visit* PeriodicDelaunay<3>::find_visit(const Location&) const;

}  // namespace flatdt::ref
