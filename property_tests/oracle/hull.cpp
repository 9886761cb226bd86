#include "oracle/hull.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace flatdt::oracle {
namespace {

/// A normal of the line (d = 2) or plane (d = 3) through the chosen points; zero if they do not span one.
Vector normal_through(const std::vector<Vector>& points, const std::vector<std::size_t>& chosen,
                      int dimension) {
  const Vector a = minus(points[chosen[1]], points[chosen[0]]);
  if (dimension == 2) return {a[1], -a[0], 0};
  return cross(a, minus(points[chosen[2]], points[chosen[0]]));
}

/// The facets of the hull with a normal of each: every choice of d points, kept if all others are on one
/// side.
std::map<std::vector<std::size_t>, Vector> facets(const std::vector<Vector>& points, int dimension) {
  std::map<std::vector<std::size_t>, Vector> found;
  std::vector<bool> mask(points.size(), false);
  std::fill_n(mask.begin(), dimension, true);
  do {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < mask.size(); ++i)
      if (mask[i]) chosen.push_back(i);
    const Vector normal = normal_through(points, chosen, dimension);
    if (normal == Vector{}) continue;
    const Rational offset = pairing(normal, points[chosen[0]]);
    std::vector<std::size_t> on;
    std::set<int> sides;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const int side = cmp(pairing(normal, points[i]), offset);
      if (side == 0)
        on.push_back(i);
      else
        sides.insert(side > 0 ? 1 : -1);
    }
    if (sides.size() == 1) found.emplace(std::move(on), normal);
  } while (std::prev_permutation(mask.begin(), mask.end()));
  return found;
}

/// The points of a facet in one dimension less: a coordinate in which the normal is not zero can be dropped,
/// since the projection is injective on the facet.
std::vector<Vector> flattened(const std::vector<Vector>& points, const std::vector<std::size_t>& facet,
                              const Vector& normal) {
  const auto dropped = static_cast<std::size_t>(
      std::find_if(normal.begin(), normal.end(), [](const Rational& x) { return x != 0; }) - normal.begin());
  std::vector<Vector> flat;
  for (const std::size_t i : facet) {
    Vector v{};
    for (std::size_t from = 0, to = 0; from < v.size(); ++from)
      if (from != dropped) v[to++] = points[i][from];
    flat.push_back(v);
  }
  return flat;
}

}  // namespace

std::vector<std::vector<std::size_t>> pulled_triangulation(const std::vector<Vector>& points, int dimension) {
  if (dimension == 1) return {{0, 1}};  // the two ends of a segment
  std::vector<std::vector<std::size_t>> simplices;
  for (const auto& [facet, normal] : facets(points, dimension)) {
    if (facet.front() == 0) continue;
    for (const std::vector<std::size_t>& base :
         pulled_triangulation(flattened(points, facet, normal), dimension - 1)) {
      std::vector<std::size_t> simplex{0};
      for (const std::size_t i : base) simplex.push_back(facet[i]);
      simplices.push_back(std::move(simplex));
    }
  }
  return simplices;
}

std::set<std::pair<std::size_t, std::size_t>> hull_edges(const std::vector<Vector>& points, int dimension) {
  if (dimension == 1) return {{0, 1}};
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [facet, normal] : facets(points, dimension))
    for (const auto& [a, b] : hull_edges(flattened(points, facet, normal), dimension - 1))
      edges.emplace(facet[a], facet[b]);
  return edges;
}

Rational hull_volume(const std::vector<Vector>& points, int dimension) {
  Rational volume = 0;
  for (const std::vector<std::size_t>& simplex : pulled_triangulation(points, dimension)) {
    std::vector<Vector> corners;
    for (const std::size_t i : simplex) corners.push_back(points[i]);
    volume += simplex_volume(corners, dimension);
  }
  return volume;
}

}  // namespace flatdt::oracle
