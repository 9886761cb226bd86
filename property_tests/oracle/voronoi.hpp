/// The definition-level oracle: the Delaunay tessellation of GP modulo G, from the Voronoi cells of the
/// points. Invariants: exact; shares no arithmetic and no geometry with ref or checker, whose `Instance` only
/// carries
///             the input.
/// Source:     DESIGN.md 4; Definitions 2 and 4 of Caroli and Teillaud with "triangulation" read as the dual
/// of
///             the Voronoi diagram, so that ties need no decision.
#pragma once

#include <cstddef>
#include <vector>

#include "flatdt/checker/input.hpp"
#include "oracle/orbit_points.hpp"

namespace flatdt::oracle {

/// A cell of the Delaunay tessellation, given by its circumscribed ball.
struct DelaunayCell {
  Vector centre;                   ///< the canonical one of its G-orbit (Group::canonical)
  Rational squared_radius;         ///< in units of the metric
  std::vector<OrbitPoint> points;  ///< all points of GP on the sphere, by position; their hull is the cell
};

/// The Delaunay tessellation of GP modulo G: one cell for each G-orbit of Voronoi vertices.
struct Tessellation {
  int dimension = 0;
  std::vector<std::size_t> representatives;  ///< the least index of each orbit of points, ascending
  std::vector<DelaunayCell> cells;           ///< by centre
  /// Some cell is no simplex, so that more than one triangulation is weakly Delaunay.
  [[nodiscard]] bool has_ties() const;
};

/// The tessellation of an instance.
/// Requires: the instance came from parse_instance and its group is admissible (torsion-free, cocompact).
/// Errors:   std::invalid_argument if the group is not crystallographic; std::logic_error if the result
///           contradicts itself (the volumes of the cells do not add up to that of E^d/G).
/// Cost:     for n points and a holonomy group of order p: O(n) clips, each followed by np searches in the
/// lattice
///           for every new vertex. Meant for n p up to about a hundred.
[[nodiscard]] Tessellation delaunay_tessellation(const checker::Instance& instance);

/// What the tessellation alone says about "X carries a Delaunay triangulation" (Definition 4).
enum class Existence {
  yes,  ///< every weakly Delaunay triangulation of GP that is invariant under G projects to one of X
  no,   ///< none does: the edges that all of them have make a loop or a 2-cycle modulo G
  depends_on_ties,  ///< neither follows from the edges that are in all, or may be in some of them
};

/// Without ties never `depends_on_ties`.
/// Source: Theorem 7 and its converse: X carries it iff no loop and no two edges modulo G with the same ends.
[[nodiscard]] Existence carries_triangulation(const Tessellation& tessellation);

}  // namespace flatdt::oracle
