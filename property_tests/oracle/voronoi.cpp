#include "oracle/voronoi.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "oracle/hull.hpp"
#include "oracle/polytope.hpp"

namespace flatdt::oracle {
namespace {

/// The points that are at most as far from p as from q: 2 <q-p, x> <= |q|^2 - |p|^2.
HalfSpace nearer_to(const Vector& p, const Vector& q, const Matrix& metric) {
  return {times(2, image(metric, minus(q, p))), square(metric, q) - square(metric, p)};
}

/// The vertices of the Voronoi cell of p in GP, each with all points of GP that are nearest to it.
///
/// Start: the bisectors of p and p +- b for the vectors b of a basis of the lattice bound a parallelotope Q,
/// which contains the cell. Step: a vertex v of Q to which some q of GP is nearer than p is cut off by the
/// bisector of p and q. Stop: no such vertex is left. Then Q is the cell: it contains the cell, since only
/// bisectors have cut it, and its vertices lie in the cell, which is convex. Bound: q is no farther from v
/// than p, so within 2R of p, R the greatest distance of a vertex of the first Q; and after the cut no vertex
/// is nearer to q than to p, so q is not used again. Such q are finitely many. (Enumerating all of GP up to
/// distance 2R cuts by the same bisectors; but a long lattice has too many of them.)
std::map<Vector, std::vector<OrbitPoint>> voronoi_vertices(const OrbitPoints& points, const Vector& p,
                                                           const Matrix& metric, int dimension) {
  Matrix rows;
  Vector bounds;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    rows[i] = image(metric, points.basis()[i]);
    bounds[i] = square(metric, points.basis()[i]) / 2;
  }
  Polytope cell = Polytope::parallelotope(p, rows, bounds, dimension);
  std::map<Vector, std::vector<OrbitPoint>> settled;
  for (bool cut = true; cut;) {
    cut = false;
    for (const Polytope::Vertex& v : cell.vertices()) {
      if (settled.contains(v.position)) continue;
      std::vector<OrbitPoint> nearest = points.nearest(v.position);
      const Vector q = nearest.front().position;
      if (square(metric, minus(q, v.position)) < square(metric, minus(p, v.position))) {
        cell.cut(nearer_to(p, q, metric));
        cut = true;
        break;  // the vertices are others now
      }
      settled.emplace(v.position, std::move(nearest));
    }
  }
  return settled;
}

/// g applied to points of GP, in the order of position.
std::vector<OrbitPoint> moved(const Seitz& g, const std::vector<OrbitPoint>& points) {
  std::vector<OrbitPoint> result;
  for (const OrbitPoint& p : points)
    result.push_back({p.point, composed(g, p.element), image(g, p.position)});
  std::sort(result.begin(), result.end(),
            [](const OrbitPoint& a, const OrbitPoint& b) { return a.position < b.position; });
  return result;
}

std::vector<Vector> positions(const std::vector<OrbitPoint>& points) {
  std::vector<Vector> result;
  for (const OrbitPoint& p : points) result.push_back(p.position);
  return result;
}

/// Edges modulo G.
class Edges {
 public:
  void add(const OrbitPoint& a, const OrbitPoint& b, int dimension) {
    if (a.point == b.point) {
      loop_ = true;
      return;
    }
    const auto& [first, second] =
        std::minmax(a, b, [](const auto& x, const auto& y) { return x.point < y.point; });
    const Seitz way = composed(inverse(first.element, dimension), second.element);
    ways_[{first.point, second.point}].insert({way.linear, way.translation});
  }
  /// No loop and no two edges modulo G with the same ends.
  [[nodiscard]] bool are_simple() const {
    return !loop_ &&
           std::all_of(ways_.begin(), ways_.end(), [](const auto& w) { return w.second.size() == 1; });
  }

 private:
  bool loop_ = false;
  /// For the edge {g p_i, h p_j}, i < j, the element g^-1 h: it determines the edge modulo G, and the
  /// reverse.
  std::map<std::pair<std::size_t, std::size_t>, std::set<std::pair<Matrix, Vector>>> ways_;
};

}  // namespace

bool Tessellation::has_ties() const {
  const auto corners = static_cast<std::size_t>(dimension) + 1;
  return std::any_of(cells.begin(), cells.end(),
                     [&](const DelaunayCell& c) { return c.points.size() != corners; });
}

Tessellation delaunay_tessellation(const checker::Instance& instance) {
  const int d = instance.dimension;
  const std::optional<Group> group = generated_group(d, instance.generators, instance.metric);
  if (!group) throw std::invalid_argument("the group is not crystallographic");
  const OrbitPoints points(*group, instance.metric, instance.points);

  std::map<Vector, DelaunayCell> cells;
  for (const std::size_t i : points.representatives()) {
    const Vector& p = instance.points[i];
    for (const auto& [vertex, nearest] : voronoi_vertices(points, p, instance.metric, d)) {
      const auto [centre, g] = group->canonical(vertex);
      cells.try_emplace(centre,
                        DelaunayCell{centre, square(instance.metric, minus(p, vertex)), moved(g, nearest)});
    }
  }

  Tessellation result{d, points.representatives(), {}};
  Rational volume = 0;
  for (auto& [centre, cell] : cells) {
    volume += hull_volume(positions(cell.points), d);
    result.cells.push_back(std::move(cell));
  }
  // G acts freely on the cells of the tessellation of E^d: a stabiliser is finite and fixes the centre.
  if (volume != group->covolume()) throw std::logic_error("the cells do not fill the manifold");
  return result;
}

Existence carries_triangulation(const Tessellation& tessellation) {
  Edges forced;    // those of the cells, which are in all triangulations
  Edges possible;  // all pairs of points of one cell
  const int d = tessellation.dimension;
  for (const DelaunayCell& cell : tessellation.cells) {
    for (const auto& [a, b] : hull_edges(positions(cell.points), d))
      forced.add(cell.points[a], cell.points[b], d);
    for (std::size_t b = 0; b < cell.points.size(); ++b)
      for (std::size_t a = 0; a < b; ++a) possible.add(cell.points[a], cell.points[b], d);
  }
  if (!forced.are_simple()) return Existence::no;
  return possible.are_simple() ? Existence::yes : Existence::depends_on_ties;
}

}  // namespace flatdt::oracle
