/// Closest lattice vectors in machine integers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flatdt/ref/linear.hpp"

namespace flatdt::ref {

/// All lattice vectors (integer coordinates) closest to x, in no particular order; nothing where the numbers
/// do not fit. Requires: the columns of the identity and minus their sum are an obtuse superbase for gram.
/// Bounds: with the metric's integers below 2^g and the common denominator of x below 2^b, and all
/// coordinates below 4 * 2^b on the way (descend), the products are below 2^(g+b+8): g + b + 8 <= 126.
/// Source: closest_vectors, of which it is the fast path; there the reasons.
std::optional<std::vector<std::array<std::int64_t, 3>>> small_closest_vectors(const Matrix& gram,
                                                                              const Vector& x);

}  // namespace flatdt::ref
