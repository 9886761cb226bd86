/// Exact predicates on points of E^d, by rational determinants: slow, short, and neither ref's nor the
/// checker's.
#pragma once

#include <vector>

#include "flatdt/ref/linear.hpp"

namespace flatdt::edits {

/// det [p_1 - p_0 .. p_d - p_0], so d! times the signed volume in coordinates. Requires: d+1 points.
[[nodiscard]] ref::Rational signed_volume(const std::vector<ref::Vector>& cell);

/// The sign of signed_volume: -1, 0 or 1.
[[nodiscard]] int orientation(const std::vector<ref::Vector>& cell);

/// 1 if q is strictly inside the ball whose boundary the d+1 points are on, 0 if on it, -1 if outside.
/// Formula: (-1)^d det (p_i - q, |p_i - q|^2), times the orientation.  Requires: orientation(cell) != 0.
[[nodiscard]] int in_ball(const ref::Matrix& gram, const std::vector<ref::Vector>& cell,
                          const ref::Vector& q);

/// The cell with the point of one corner replaced.
[[nodiscard]] std::vector<ref::Vector> replaced(std::vector<ref::Vector> cell, std::size_t corner,
                                                const ref::Vector& by);

}  // namespace flatdt::edits
