/// Spheres and orientations from their definitions, in exact rationals.
#pragma once

#include <optional>
#include <vector>

#include "flatdt/ref/linear.hpp"

namespace flatdt::property_tests {

struct Sphere {
  ref::Vector centre;
  ref::Rational squared_radius;
};

/// The sphere through d+1 points; nothing if they lie on a hyperplane.
/// Formula: c = p_0 + c' with 2 (p_k - p_0)^T G c' = |p_k - p_0|^2.
std::optional<Sphere> circumsphere(const ref::Matrix& gram, const std::vector<ref::Vector>& points);

/// Sign of det(p_1 - p_0, ..., p_d - p_0). Requires: d+1 points.
ref::Sign orientation(const std::vector<ref::Vector>& points);

}  // namespace flatdt::property_tests
