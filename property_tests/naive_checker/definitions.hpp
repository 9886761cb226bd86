/// The definitions of the paper, decided directly in E^d.
/// Source: Definitions 1 to 4 of Caroli and Teillaud, for E^d/H; docs/soundness.md, section 1, (a) to (c).
#pragma once

#include <vector>

#include "flatdt/checker/input.hpp"
#include "naive_checker/face_complex.hpp"
#include "naive_checker/naive_check.hpp"
#include "oracle/group.hpp"

namespace flatdt::naive {

/// No point of GP is strictly inside the circumscribed ball of a cell that is not flat.
[[nodiscard]] bool balls_are_empty(const FaceComplex& complex, const oracle::Group& group,
                                   const checker::Instance& instance);

/// Every point of GP is a vertex of HK: all right cosets Hg are visited by multiplying with generators of G.
/// Cost: linear in [G:H] times the number of points.
[[nodiscard]] bool has_all_vertices(const FaceComplex& complex, const oracle::Group& group,
                                    const checker::Instance& instance);

/// How the simplices of HK meet.
struct Intersections {
  /// Any two different simplices of HK meet in a common face or not at all, and no H-orbit is listed twice.
  bool face_to_face = true;
  /// No cell meets an image of itself under H, and of the images of another cell it meets at most one. In a
  /// face-to-face family this is Definition 3 and Definition 1 (ii) for the images in E^d/H: the intersection
  /// of pi(s) and pi(t) is the union of the pi(s and ht) over h, a union of faces of s. It is one face of s
  /// iff one of these faces is that face; then the others share a vertex with it, which gives two points of t
  /// in one orbit.
  bool at_most_once = true;
};

/// Intersects every cell with every lift of a cell that its bounding box (in lattice coordinates of H) meets.
/// Requires: no cell is flat. Cost: quadratic in the number of cells.
[[nodiscard]] Intersections intersections(const FaceComplex& complex);

}  // namespace flatdt::naive
