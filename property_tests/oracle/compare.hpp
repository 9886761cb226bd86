/// Whether a triangulation of X or of a cover E^d/H refines the Delaunay tessellation: equality up to ties.
#pragma once

#include <string>

#include "flatdt/checker/input.hpp"
#include "oracle/voronoi.hpp"

namespace flatdt::oracle {

/// The first difference between a triangulation and the tessellation of its instance; empty if there is none.
/// Equal means, for every G-orbit of Voronoi vertices and each of its [G:H] H-orbits v: the triangulation's
/// cells whose circumcentre is v have their vertices among the points of the sphere about v, their interiors
/// are disjoint, and their volumes add up to that of the convex hull of these points; and there are no other
/// cells. Requires: `tessellation` is that of `instance`, and the triangulation came from parse_triangulation
/// with it. Cost:     linear in the number of cells, times [holonomy].
[[nodiscard]] std::string difference(const checker::Instance& instance, const Tessellation& tessellation,
                                     const checker::Triangulation& triangulation);

}  // namespace flatdt::oracle
