/// Point location by visibility walks over lifts (Section 4.2, geometric step).
#include <cmath>

#include "flatdt/ref/periodic_delaunay.hpp"

namespace flatdt::ref {

/// The first orbit is complete, so the copy of its first vertex within one period of the query is a vertex:
/// the walk is short however large the cover is. (Rejected: a copy modulo H only. Measured on a torus of axis
/// ratio 1:5000 in a cover of 17,000 sheets, the walks took nearly all of the time.)
template <int D>
OrbitPoint PeriodicDelaunay<D>::start_near(const Lift& query) const {
  const auto& vertex = complex_.vertex(VertexId{0});
  Element s;
  for (std::size_t i = 0; i < D; ++i) {
    const double steps = std::round(query.x[i] - vertex.x[i]);
    if (std::fabs(steps) > 32767) throw LimitReached("the covering is longer than 32767 lattice vectors");
    s.t[i] = static_cast<std::int16_t>(steps);
  }
  const OrbitPoint base = complex_.point(VertexId{0});
  return {base.site, setting_.table->multiply(s, base.g)};
}

template <int D>
Location PeriodicDelaunay<D>::locate(SiteId site, const Element& query, const OrbitPoint& near) {
  const GroupTable& table = *setting_.table;
  const Subgroup::Split split = complex_.subgroup().split(near.g);
  const VertexId start = complex_.vertex_of(near.site, split.rep);
  Location at{complex_.vertex(start).cell, {}};
  {
    const auto& cell = complex_.cell(at.cell);
    std::size_t k = 0;
    while (cell.vertex[k] != start) ++k;
    // The lift with this vertex at s * base is s offset^-1; the query is seen through its inverse.
    at.seen = table.multiply(table.multiply(complex_.offset(at.cell, k), table.inverse(split.s)), query);
  }
  const std::array<double, 3> coordinates = complex_.approximate(site);
  CellId previous = kNoCell;
  Element previous_gluing{};
  for (;;) {
    const auto lifts = complex_.base_coordinates(at.cell);
    const auto seen = table.apply(at.seen, coordinates);
    // A pseudo-random first facet: a fixed order makes walks long on regular grids.
    walk_state_ = walk_state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    const std::uint32_t first = static_cast<std::uint32_t>(walk_state_ >> 33) % (D + 1);
    bool moved_on = false;
    for (std::uint32_t i = 0; i <= D && !moved_on; ++i) {
      const std::uint32_t k = (first + i) % (D + 1);
      const auto& cell = complex_.cell(at.cell);
      if (cell.neighbour[k] == previous && complex_.gluing(at.cell, k) == previous_gluing) continue;
      auto replaced = lifts;
      replaced[k] = seen;
      std::optional<Sign> side = setting_.predicates->quick_orientation(replaced);
      if (!side) {
        std::array<Lift, D + 1> exactly = complex_.base_lift(at.cell);
        exactly[k] = complex_.lift(OrbitPoint{site, at.seen});
        side = setting_.predicates->orientation(exactly);
      }
      if (*side != Sign::negative) continue;
      const Element back = table.inverse(complex_.gluing(at.cell, k));
      previous = at.cell;
      previous_gluing = back;
      at = {cell.neighbour[k], table.multiply(back, at.seen)};
      moved_on = true;
    }
    if (!moved_on) return at;
  }
}

template <int D>
OrbitPoint PeriodicDelaunay<D>::nearest_vertex(SiteId site, const Element& query, const Location& at) const {
  const GroupTable& table = *setting_.table;
  const std::array<Lift, D + 1> lifts = complex_.base_lift(at.cell);
  const Lift seen = complex_.lift(OrbitPoint{site, at.seen});
  std::size_t best = 0;
  double least = 0;
  for (std::size_t k = 0; k <= D; ++k) {
    const double distance = setting_.predicates->filter().approximate_squared_distance(lifts[k].x, seen.x);
    if (k == 0 || distance < least) {
      least = distance;
      best = k;
    }
  }
  const Element lift = table.multiply(query, table.inverse(at.seen));
  return {lifts[best].point.site, table.multiply(lift, lifts[best].point.g)};
}

template OrbitPoint PeriodicDelaunay<2>::start_near(const Lift&) const;
template OrbitPoint PeriodicDelaunay<3>::start_near(const Lift&) const;
template Location PeriodicDelaunay<2>::locate(SiteId, const Element&, const OrbitPoint&);
template Location PeriodicDelaunay<3>::locate(SiteId, const Element&, const OrbitPoint&);
template OrbitPoint PeriodicDelaunay<2>::nearest_vertex(SiteId, const Element&, const Location&) const;
template OrbitPoint PeriodicDelaunay<3>::nearest_vertex(SiteId, const Element&, const Location&) const;

}  // namespace flatdt::ref
