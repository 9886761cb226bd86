/// The topological conditions of FORMAT.md, computed from the faces alone.
#pragma once

#include "naive_checker/abelian.hpp"
#include "naive_checker/face_complex.hpp"

namespace flatdt::naive {

/// The link of every vertex of HK is a (d-1)-sphere: in the plane one cycle; in space a connected closed
/// surface of Euler number 2.
[[nodiscard]] bool links_are_spheres(const FaceComplex& complex);

/// The graph of cells and facets has at most one component.
[[nodiscard]] bool is_connected(const FaceComplex& complex);

/// The alternating sum of the numbers of faces.
[[nodiscard]] long euler_number(const FaceComplex& complex);

/// Signs can be given to the cells such that across every facet the induced orientations are opposite.
/// Requires: every facet occurs exactly twice.
[[nodiscard]] bool is_orientable(const FaceComplex& complex);

/// ker(boundary of edges) / im(boundary of triangles).
[[nodiscard]] AbelianGroup first_homology(const FaceComplex& complex);

}  // namespace flatdt::naive
