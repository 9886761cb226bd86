#include "long_lattice_star.hpp"

#include <algorithm>
#include <set>

#include "flatdt/ref/first_orbit.hpp"
#include "flatdt/ref/orbit_position.hpp"

namespace flatdt::ref {
namespace {

/// The numbers of a point are too large for the fixed width: for this file only.
struct DoesNotFit {};

}  // namespace

template <int D>
LongLatticeStar<D>::LongLatticeStar(const Setting<D>& setting, const QuotientComplex<D>& complex,
                                    const OrbitPoint& q)
    : setting_(setting),
      complex_(&complex),
      inverse_gram_(setting.frame->gram.inverse()),
      star_(complex.lift(q), *setting.predicates) {
  for (const CellPoints<D>& points : star_in_own_orbit<D>(*setting.frame, *setting.table, *setting.sites,
                                                          *setting.predicates, complex.subgroup(), q)) {
    std::array<Lift, D + 1> lifts;
    for (std::size_t k = 0; k <= D; ++k) lifts[k] = complex.lift(points[k]);
    star_.add(lifts);
  }
  // Bounded: each insertion makes a further point of GP a neighbour of q, within q + 2V, where V is the
  // Voronoi cell of the lattice.
  for (std::size_t i = 0; i < star_.cells().size();) {
    if (star_.cells()[i].certified) {
      ++i;
      continue;
    }
    if (const auto vertex = conflicting_vertex(star_.cells()[i])) {
      ensure(star_.insert(*vertex), "a vertex in conflict with a cell of the star changes the star");
      i = 0;
    } else {
      star_.cells()[i].certified = true;
    }
  }
}

template <int D>
Vector LongLatticeStar<D>::circumcentre(const std::array<Lift, D + 1>& cell) const {
  // With rows a_k = p_k - p_0: 2 A G (c - p_0) = (|a_k|^2).
  const Vector origin = position(*setting_.table, *setting_.sites, cell[0].point);
  Matrix rows(D);
  Vector right(D);
  for (int k = 0; k < D; ++k) {
    const Vector a =
        position(*setting_.table, *setting_.sites, cell[static_cast<std::size_t>(k) + 1].point) - origin;
    for (int j = 0; j < D; ++j) rows(k, j) = a[j];
    right[k] = squared_length(setting_.frame->gram, a);
  }
  return origin + Rational(Integer(1), Integer(2)) * (inverse_gram_ * (rows.inverse() * right));
}

template <int D>
Rational LongLatticeStar<D>::squared_distance(const Vector& centre, const OrbitPoint& p) const {
  return squared_length(setting_.frame->gram, position(*setting_.table, *setting_.sites, p) - centre);
}

template <int D>
std::vector<OrbitPoint> LongLatticeStar<D>::neighbours(const OrbitPoint& p) const {
  std::vector<OrbitPoint> found;
  for (const auto& at : complex_->star(p))
    for (const OrbitPoint& other : complex_->points(at))
      if (other != p) found.push_back(other);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// The translate of the first vertex whose coordinates differ from those of x by at most 1/2.
template <int D>
OrbitPoint LongLatticeStar<D>::vertex_near(const Vector& x) const {
  const OrbitPoint& first = complex_->vertex(VertexId{0}).point;
  Vector steps = x - position(*setting_.table, *setting_.sites, first);
  for (int i = 0; i < D; ++i) steps[i] = Rational(round_half_up(steps[i]));
  return {first.site, setting_.table->multiply(setting_.table->element(Isometry::translate(steps)), first.g)};
}

/// A vertex of GP in conflict with the cell, if there is one.
/// A vertex of a Delaunay triangulation that is not nearest to a point c has a neighbour nearer to c; so the
/// walk ends at a nearest vertex, and the others that are as near form one Delaunay face with it, so that
/// they are found along edges. Distances from the circumcentre are compared by `power_of`: larger is nearer,
/// 0 is on the sphere.
template <int D>
template <class PowerOf>
std::optional<Lift> LongLatticeStar<D>::nearest_in_conflict(const typename LiftedStar<D>::Cell& cell,
                                                            OrbitPoint nearest,
                                                            const PowerOf& power_of) const {
  auto power = power_of(nearest);
  for (bool nearer = true; nearer;) {
    nearer = false;
    for (const OrbitPoint& p : neighbours(nearest)) {
      const auto other = power_of(p);
      if (!(power < other)) continue;
      nearest = p;
      power = other;
      nearer = true;
    }
  }
  if (power.sign() == Sign::positive) return complex_->lift(nearest);
  if (power.sign() == Sign::negative) return std::nullopt;
  std::vector<OrbitPoint> equals{nearest};
  std::set<OrbitPoint> known{nearest};
  for (std::size_t i = 0; i < equals.size(); ++i) {
    const Lift lift = complex_->lift(equals[i]);
    const bool is_vertex = std::any_of(cell.lifts.begin(), cell.lifts.end(),
                                       [&](const Lift& v) { return v.point == lift.point; });
    if (!is_vertex && setting_.predicates->conflict_sos(cell.lifts, lift)) return lift;
    for (const OrbitPoint& p : neighbours(equals[i]))
      if (power_of(p) == power && known.insert(p).second) equals.push_back(p);
  }
  return std::nullopt;
}

template <int D>
std::optional<Lift> LongLatticeStar<D>::conflicting_vertex(const typename LiftedStar<D>::Cell& cell) const {
  const Vector centre = circumcentre(cell.lifts);
  const OrbitPoint start = vertex_near(centre);
  CellPoints<D> points;
  for (std::size_t k = 0; k <= D; ++k) points[k] = cell.lifts[k].point;
  const FixedPredicates<D>& fixed = setting_.predicates->fixed();
  try {
    return nearest_in_conflict(cell, start, [&](const OrbitPoint& p) {
      const auto value = fixed.insphere_value(points, p);
      if (!value) throw DoesNotFit{};
      return *value;
    });
  } catch (const DoesNotFit&) {
    const Rational radius = squared_distance(centre, cell.lifts[0].point);
    return nearest_in_conflict(cell, start,
                               [&](const OrbitPoint& p) { return radius - squared_distance(centre, p); });
  }
}

/// The stars of all copies of q fill the union of the cells in conflict with some copy. A facet without
/// copies of q on the boundary of a star is a facet of the old triangulation too, and the other facets of
/// cells in conflict are not facets of the new one. So flood from the located cell and from the cell on q's
/// side of each such facet, never crossing one; every part of the union has a cell to start from.
template <int D>
std::vector<CellId> LongLatticeStar<D>::conflicts(CellId located) const {
  const GroupTable& table = *setting_.table;
  const Subgroup& subgroup = complex_->subgroup();
  const OrbitPoint& q = star_.centre().point;
  const auto is_copy = [&](const OrbitPoint& p) {
    return p.site == q.site && subgroup.split(p.g).rep == subgroup.split(q.g).rep;
  };
  std::vector<CellId> open{located};
  std::set<std::array<OrbitPoint, D>> walls;
  for (const auto& cell : star_.cells()) {
    std::array<OrbitPoint, D> facet;
    std::size_t count = 0;
    std::size_t apex = 0;
    for (std::size_t k = 0; k <= D; ++k)
      if (cell.lifts[k].point == q)
        apex = k;
      else if (!is_copy(cell.lifts[k].point))
        facet[count++] = cell.lifts[k].point;
    if (count != D) continue;
    walls.insert(canonical_face<D>(table, subgroup, facet).key);
    // Of the two old cells at the facet, the one on q's side.
    std::size_t cells_there = 0;
    for (const auto& at : complex_->star(facet[0])) {
      const CellPoints<D> points = complex_->points(at);
      std::size_t shared = 0;
      OrbitPoint opposite{};
      for (const OrbitPoint& p : points)
        if (std::find(facet.begin(), facet.end(), p) != facet.end())
          ++shared;
        else
          opposite = p;
      if (shared != D) continue;
      ++cells_there;
      std::array<Lift, D + 1> replaced = cell.lifts;
      replaced[apex] = complex_->lift(opposite);
      if (setting_.predicates->orientation(replaced) == Sign::positive) open.push_back(at.cell);
    }
    ensure(cells_there == 2, "a facet of the star without copies of its centre is a facet of two old cells");
  }
  std::set<CellId> found(open.begin(), open.end());
  open.assign(found.begin(), found.end());
  while (!open.empty()) {
    const CellId c = open.back();
    open.pop_back();
    for (std::uint32_t k = 0; k <= D; ++k) {
      const CellId next = complex_->cell(c).neighbour[k];
      if (walls.count(complex_->facet(c, k).key) != 0) continue;
      if (found.insert(next).second) open.push_back(next);
    }
  }
  return {found.begin(), found.end()};
}

template class LongLatticeStar<2>;
template class LongLatticeStar<3>;

}  // namespace flatdt::ref
