/// Comparison of a result of the reference with the definition-level oracle.
#pragma once

#include "flatdt/ref/triangulate.hpp"

namespace flatdt::property_tests {

/// Throws Violation unless the written cells refine the oracle's Delaunay tessellation, the points are as
/// many, and the manifold is answered where every (no) triangulation of the points projects to one.
void require_equal_to_oracle(const ref::Instance& instance, const ref::TriangulationResult& result);

}  // namespace flatdt::property_tests
