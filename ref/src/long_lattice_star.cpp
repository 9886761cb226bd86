#include "long_lattice_star.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "fixed_sphere.hpp"
#include "flatdt/ref/first_orbit.hpp"
#include "flatdt/ref/orbit_position.hpp"

namespace flatdt::ref {

template <int D>
LongLatticeStar<D>::LongLatticeStar(const Setting<D>& setting, const QuotientComplex<D>& complex,
                                    const OrbitPoint& q, const Location& located)
    : setting_(setting),
      complex_(&complex),
      located_(located.cell),
      rep_(complex.subgroup().split(q.g).rep),
      neighbours_(complex.vertex_count()),
      star_(complex.lift(q), *setting.predicates),
      around_(setting.predicates->filter(), star_.centre().x, setting.predicates->uses_filter()) {
  for (const CellPoints<D>& points : star_in_own_orbit<D>(*setting.frame, *setting.table, *setting.sites,
                                                          *setting.predicates, complex.subgroup(), q)) {
    std::array<Lift, D + 1> lifts;
    for (std::size_t k = 0; k <= D; ++k) lifts[k] = complex.lift(points[k]);
    star_.add(lifts);
  }
  insert_vertices(located);
  complete();
}

/// Those of the cell around q. They leave few cells without vertices of the complex: a ball through q that is
/// large beside this cell has one of its vertices inside, nearly always.
template <int D>
void LongLatticeStar<D>::insert_vertices(const Location& located) {
  const GroupTable& table = *setting_.table;
  const Element lift = table.multiply(star_.centre().point.g, table.inverse(located.seen));
  for (std::size_t k = 0; k <= D; ++k) {
    const Element offset = table.multiply(lift, complex_->offset(located.cell, k));
    star_.insert(complex_->lift(complex_->cell(located.cell).vertex[k], offset));
  }
}

/// Bounded: each insertion makes a further point of GP a neighbour of q, within q + 2V, where V is the
/// Voronoi cell of the lattice.
template <int D>
void LongLatticeStar<D>::complete() {
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
Vector LongLatticeStar<D>::circumcentre(const CellPoints<D>& cell) const {
  // With rows a_k = p_k - p_0: 2 A G (c - p_0) = (|a_k|^2).
  const Matrix& gram = setting_.frame->gram;
  const Vector origin = position(*setting_.table, *setting_.sites, cell[0]);
  Matrix rows(D);
  Vector right(D);
  for (int k = 0; k < D; ++k) {
    const Vector a =
        position(*setting_.table, *setting_.sites, cell[static_cast<std::size_t>(k) + 1]) - origin;
    for (int j = 0; j < D; ++j) rows(k, j) = a[j];
    right[k] = squared_length(gram, a);
  }
  return origin + Rational(Integer(1), Integer(2)) * ((rows * gram).inverse() * right);
}

/// Calls visit(other) for the neighbours of a point of GP in the complex, as long as it returns true.
template <int D>
template <class Visit>
void LongLatticeStar<D>::visit_neighbours(const OrbitPoint& p, const Visit& visit) {
  const Subgroup::Split split = complex_->subgroup().split(p.g);
  const VertexId v = complex_->vertex_of(p.site, split.rep);
  std::vector<OrbitPoint>& found = neighbours_[index_of(v)];
  if (found.empty()) found = complex_->neighbours(v);
  for (const OrbitPoint& other : found)
    if (!visit(OrbitPoint{other.site, setting_.table->multiply(split.s, other.g)})) return;
}

/// The translate of the first vertex whose coordinates differ from those of x by about 1/2 at most.
template <int D>
OrbitPoint LongLatticeStar<D>::vertex_near(const Vector& x) const {
  constexpr double kFarthest = 30000;
  const Lift first = complex_->lift(complex_->point(VertexId{0}));
  Element steps;
  for (std::size_t i = 0; i < D; ++i) {
    const double step = std::round(x[static_cast<int>(i)].to_double() - first.x[i]);
    if (std::fabs(step) < kFarthest) steps.t[i] = static_cast<std::int16_t>(step);
  }
  return {first.point.site, setting_.table->multiply(steps, first.point.g)};
}

/// Of the vertices of GP in conflict with the cell and next to one of its own, one that is near q; nothing if
/// no vertex of GP at all is in conflict.
/// Let g(u) be the height of a point u, raised by the perturbation, above the hyperplane through the raised
/// vertices of the cell. DT(GP) is the lower hull of raised points, so g, made linear on its cells, is
/// convex; it is 0 at the vertex, and if it is not negative at the neighbours, it is negative nowhere.
template <int D>
std::optional<Lift> LongLatticeStar<D>::conflicting_neighbour(const Cell& cell, const OrbitPoint& vertex) {
  for (const Lift& v : cell.lifts) around_.see(v.x);
  std::optional<Lift> nearest;
  double least = 0;
  visit_neighbours(vertex, [&](const OrbitPoint& p) {
    const Lift w = complex_->lift(p);
    const auto seen = around_.see(w.x);
    const std::optional<Sign> quick = around_.insphere(cell.sphere, seen);
    const auto is_w = [&p](const Lift& v) { return v.point == p; };
    const bool in_conflict = quick ? *quick == Sign::positive
                                   : std::none_of(cell.lifts.begin(), cell.lifts.end(), is_w) &&
                                         setting_.predicates->conflict_sos(cell.lifts, w);
    if (in_conflict && (!nearest || seen.length < least)) {
      nearest = w;
      least = seen.length;
    }
    return true;
  });
  return nearest;
}

/// A vertex of GP in conflict with the cell, if there is one; `nearest`: any, better one near the centre.
/// A vertex of a Delaunay triangulation that is not nearest to a point c has a neighbour nearer to c; so the
/// walk ends at a nearest vertex, and the others that are as near form one Delaunay face with it, so that
/// they are found along edges. Distances from the circumcentre are compared by `power_of`: larger is nearer,
/// 0 is on the sphere; nothing where its numbers do not fit, and then nothing at all.
template <int D>
template <class PowerOf>
typename LongLatticeStar<D>::Search LongLatticeStar<D>::nearest_in_conflict(
    const std::array<Lift, D + 1>& cell, OrbitPoint nearest, const PowerOf& power_of) {
  auto power = power_of(nearest);
  if (!power) return {false, std::nullopt};
  bool fits = true;
  for (bool nearer = true; nearer;) {
    nearer = false;
    visit_neighbours(OrbitPoint(nearest), [&](const OrbitPoint& p) {
      const auto other = power_of(p);
      fits = other.has_value();
      if (fits && *power < *other) {
        nearest = p;
        power = other;
        nearer = true;
      }
      return fits;
    });
    if (!fits) return {false, std::nullopt};
  }
  if (power->sign() == Sign::positive) return {true, complex_->lift(nearest)};
  if (power->sign() == Sign::negative) return {true, std::nullopt};
  std::vector<OrbitPoint> equals{nearest};
  std::set<OrbitPoint> known{nearest};
  for (std::size_t i = 0; i < equals.size(); ++i) {
    const Lift lift = complex_->lift(equals[i]);
    if (setting_.predicates->conflict_sos(cell, lift)) return {true, lift};
    visit_neighbours(OrbitPoint(equals[i]), [&](const OrbitPoint& p) {
      const auto other = power_of(p);
      fits = other.has_value();
      if (fits && *other == *power && known.insert(p).second) equals.push_back(p);
      return fits;
    });
    if (!fits) return {false, std::nullopt};
  }
  return {true, std::nullopt};
}

template <int D>
std::optional<Lift> LongLatticeStar<D>::conflicting_vertex(const Cell& cell) {
  for (const Lift& v : cell.lifts)
    if (!is_copy(v.point)) return conflicting_neighbour(cell, v.point);
  return conflicting_nearest(cell.lifts);
}

/// For cells of copies of q alone, which have no vertex to begin with.
template <int D>
std::optional<Lift> LongLatticeStar<D>::conflicting_nearest(const std::array<Lift, D + 1>& cell) {
  CellPoints<D> points;
  for (std::size_t k = 0; k <= D; ++k) points[k] = cell[k].point;
  const Vector centre = circumcentre(points);
  const OrbitPoint start = vertex_near(centre);
  if (setting_.predicates->uses_fixed())
    if (const auto sphere = FixedSphere<D>::make(setting_.predicates->fixed(), points)) {
      const Search search =
          nearest_in_conflict(cell, start, [&](const OrbitPoint& p) { return sphere->power(p); });
      if (search.fits) return search.vertex;
    }
  const auto squared_distance = [&](const OrbitPoint& p) {
    return squared_length(setting_.frame->gram, position(*setting_.table, *setting_.sites, p) - centre);
  };
  const Rational radius = squared_distance(points[0]);
  return nearest_in_conflict(
             cell, start,
             [&](const OrbitPoint& p) { return std::optional<Rational>(radius - squared_distance(p)); })
      .vertex;
}

/// The stars of all copies of q fill the union of the cells in conflict with some copy: modulo the group, of
/// the cells in conflict with q. A facet without copies of q on the boundary of a star, a wall, is a facet of
/// the new triangulation; one between two cells in conflict with q is not. The latter cells are connected by
/// such facets, for their union is star-shaped around q. So flood from the located cell, crossing no wall.
template <int D>
std::vector<CellId> LongLatticeStar<D>::conflicts() const {
  std::set<std::array<OrbitPoint, D>> walls;
  for (const auto& cell : star_.cells()) {
    std::array<OrbitPoint, D> facet;
    std::size_t count = 0;
    for (const Lift& vertex : cell.lifts)
      if (!is_copy(vertex.point)) facet[count++] = vertex.point;
    if (count == D) walls.insert(canonical_face<D>(*setting_.table, complex_->subgroup(), facet).key);
  }
  std::vector<CellId> open{located_};
  std::set<CellId> found{located_};
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
