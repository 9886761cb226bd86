/// The partial claim of programs that give neighbours and no cells: edges of the Delaunay graph modulo the
/// group.
///
///     flatdt-edges 1
///     elements 3              # group elements, as in a triangulation file
///       1 0 0  0 1 0
///       ...
///     edges 6                 # two vertices each, (point, element), as in a cell
///       0 0  1 2
///       ...
///
/// Conditions: `edges.member`: every element is in the group; `edges.delaunay`: the ends of every edge lie on
/// an empty sphere together; `edges.present`: every pair of vertices whose Voronoi cells share a facet (of
/// positive area) is there, unless the facet is smaller than a resolution. Pairs whose Voronoi cells meet in
/// less are free to be there or not, so that ties do not matter. Source: docs/campaigns.md, "Claims of
/// edges".
#pragma once

#include <string>

#include "flatdt/ref/exact.hpp"

namespace flatdt::campaign {

struct Judgement;

/// Judges such a file by the triangulation that ref computes.
/// Cost: that of ref::triangulate, and linear in the edges; cells of one tie pay their square.
[[nodiscard]] Judgement judge_edges(const std::string& instance, const std::string& output,
                                    const ref::Rational& facet_resolution);

}  // namespace flatdt::campaign
