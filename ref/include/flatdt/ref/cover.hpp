/// Which sublattice S of the translation lattice L gives a covering space E^d/S in which every point set has
/// a Delaunay triangulation. mu is the covering radius of L.
/// Requires of a frame, everywhere: gram reduced as by reduce_basis, cosets one for each linear part; nothing
/// else of it is used.
/// Source: DESIGN.md section 3, "Covers"; Caroli & Teillaud, Theorems 4 and 10.
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
/// The search is not begun where Hermite's constant asks for an index above kMaxSearchedIndexInPlane or
/// kMaxSearchedIndexInSpace, and given up after kMaxSearchWork steps. Then the answer is the one of least
/// index among theorem10_cover and the product lattice <c_1 e_1, .., c_d e_d>, c_i the least integer such
/// that c_i times the height of e_i over the other basis vectors exceeds 4 mu, raised to the maximum over
/// each block of coordinates that the holonomy mixes. It is as safe, only larger. Which of the two happens
/// depends on the frame alone (steps are counted, not seconds). The search is complete for axis ratios up to
/// 1:1:10 or 1:5000 in 2D, in about a second at most.
Sublattice one_at_a_time_cover(const Frame& frame, long max_sheets);
inline constexpr long kMaxSearchedIndexInPlane = 20000;
/// The steps of one index grow with its square in 3D.
inline constexpr long kMaxSearchedIndexInSpace = 1500;
/// Elementary steps of the search for one_at_a_time_cover, a few nanoseconds each.
inline constexpr long kMaxSearchWork = 300'000'000;

/// The sublattice of least index (ties: least Hermite normal form, column by column: the order of the entries
/// (a,p,q,b,r,c) of columns (a,p,q), (0,b,r), (0,0,c)) that is invariant under the holonomy and meets 4V in 0
/// only, V the closed Voronoi cell of L: safe for complete orbits.
/// Index at most 3^d: 3h in 4V means <3h,n> <= 2 <n,n> for all n of L; n = h gives h = 0.
Sublattice complete_orbit_cover(const Frame& frame);

/// The sublattice of least index (ties as above) that is invariant under the holonomy and contains none of
/// the given vectors. Requires: they are symmetric, without 0, integral, and lie in 4V, so that the index is
/// at most that of complete_orbit_cover.
Sublattice smallest_cover_without(const Frame& frame, const std::vector<Vector>& vectors);

/// The criterion of one_at_a_time_cover: every nonzero vector of the sublattice (columns) is longer than 4
/// mu.
bool is_safe_for_single_copies(const Matrix& gram, const Matrix& sublattice);
/// The criterion of complete_orbit_cover: every nonzero g of the sublattice (columns) has an n in L with
/// <g,n> > 2 <n,n>.
bool is_safe_for_complete_orbits(const Matrix& gram, const Matrix& sublattice);

}  // namespace flatdt::ref
