/// CGAL's periodic Delaunay triangulations as an optional peer.
/// Every function gives work on points in CGAL's own form, converted beforehand.
#pragma once

#include <string>

#include "experiment.hpp"
#include "point_sets.hpp"

namespace flatdt::bench {

/// "" if CGAL was not there when this program was built; the others must not be called then.
std::string peer_version();

/// Range insertion in large-point-set mode: 36 (2D: 13) dummy points first, one sheet from the start.
Work peer_batch(const PointSet& set);
/// Range insertion into the hierarchy. Requires: dimension 2.
Work peer_hierarchy(const PointSet& set);
/// One insertion after the other, in copies as long as CGAL needs them.
Work peer_one_by_one(const PointSet& set);
/// is_valid() of the triangulation by peer_batch. Errors: std::runtime_error if it says no.
Work peer_validity(const PointSet& set);

}  // namespace flatdt::bench
