/// Convex hulls of finitely many points of which each is a vertex of the hull, such as points on a sphere.
#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "oracle/linear.hpp"

namespace flatdt::oracle {

/// A triangulation of the hull without new vertices: d+1 indices for each simplex (Lee's pulling
/// triangulation: the first point with the simplices of the facets that miss it). Requires: the points span
/// E^d, are different, and each is a vertex of the hull. Cost: O(n^(d+1)).
[[nodiscard]] std::vector<std::vector<std::size_t>> pulled_triangulation(const std::vector<Vector>& points,
                                                                         int dimension);

/// The edges of the hull, each as two ascending indices. Requires: as above. Cost: O(n^(d+1)).
[[nodiscard]] std::set<std::pair<std::size_t, std::size_t>> hull_edges(const std::vector<Vector>& points,
                                                                       int dimension);

/// The volume of the hull in coordinates. Requires: as above.
[[nodiscard]] Rational hull_volume(const std::vector<Vector>& points, int dimension);

}  // namespace flatdt::oracle
