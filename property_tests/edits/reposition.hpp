/// The same complex with its vertices elsewhere: what has become of the triangulation?
///
/// Let a valid triangulation of E^d/H be given, and let every vertex g p_i move to g q_i. This map extends to
/// E^d, linearly on every cell; it commutes with H and moves no point far, so it has degree 1, and the signed
/// volumes (signed against those before) sum to that of E^d/H.
/// - If a cell has volume 0: cells.nondegenerate fails.
/// - If no cell has, and some cell has turned over: the volumes sum to more, so volume.exact fails; not all
/// have turned
///   over, so across some facet one cell has and its neighbour has not: both apices are on one side.
/// - If none has: the map is a homeomorphism, and the cells tile. Then they are weakly Delaunay iff each
/// facet is.
#pragma once

#include "base.hpp"

namespace flatdt::edits {

enum class Repositioned { flat, folded, not_delaunay, valid };

/// Requires: the cells of `now` are those of the base, with the same elements and H; every orbit of points
/// has as many members in the list of `now` as before, and different orbits stay different
/// (points_stay_distinct).
[[nodiscard]] Repositioned repositioned(const Base& base, const Case& now);

/// No two points of the instance are in one orbit. Requires: the group is that of the base.
[[nodiscard]] bool points_stay_distinct(const Base& base, const ref::Instance& now);

}  // namespace flatdt::edits
