/// Which sublattice S of the translation lattice L gives a covering space E^d/S in which every point set has
/// a Delaunay triangulation.
#pragma once

#include <vector>

#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::ref {

/// A sublattice of Z^d in frame coordinates.
struct Sublattice {
  /// Integral lower-triangular Hermite normal form, columns; det > 0 is the index in L.
  Matrix basis{0};
  /// Index in L.
  long index = 0;
  /// index * holonomy order: copies per point.
  long sheets = 0;
};

/// c*L of Theorem 10 with the least c such that c * shortest > 4 mu (2 Delta(G_T p) = 4 mu).
/// Throws LimitReached if it has more than max_sheets sheets.
Sublattice theorem10_cover(const Frame& frame, long max_sheets);

/// The sublattice of least index (ties: least Hermite normal form, column by column) that is invariant under
/// the holonomy and in which every nonzero vector is longer than 4 mu: safe for copies inserted one at a time
/// (Theorem 4). Throws LimitReached if it has more than max_sheets sheets.
Sublattice one_at_a_time_cover(const Frame& frame, long max_sheets);

/// The sublattice of least index (ties: least Hermite normal form) that is invariant under the holonomy and
/// meets 4V in 0 only, V the closed Voronoi cell of L: safe for complete orbits. Index at most 3^d.
Sublattice complete_orbit_cover(const Frame& frame);

}  // namespace flatdt::ref
