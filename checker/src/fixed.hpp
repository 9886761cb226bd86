// Lattice coordinates as machine integers over one common denominator, where the input allows it.
//
// All numbers stay below kFixedLimit in absolute value, so that differences fit 64 bits with a bit to spare.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "flatdt/checker/exact.hpp"
#include "flatdt/checker/input.hpp"
#include "group.hpp"

namespace flatdt::checker {

__extension__ using Int128 = __int128;

inline constexpr std::int64_t kFixedLimit = std::int64_t{1} << 61;

/// x if |x| < kFixedLimit.
[[nodiscard]] std::optional<std::int64_t> to_fixed(const Integer& x);

/// Points in lattice coordinates of G times the denominator.
struct FixedPoints {
  std::int64_t denominator = 1;  ///< a multiple of the denominators of G's translations
  std::vector<Vec<std::int64_t>> numerator;
};

/// The points of the instance, unreduced; nothing if some number does not fit.
[[nodiscard]] std::optional<FixedPoints> fixed_points(const Instance& instance, const Group& group);

/// An element of G on numerators over a denominator D: x -> linear x + D (t + l).
struct FixedMap {
  bool is_translation;
  Mat<std::int64_t> linear;
  Vec<std::int64_t> translation;

  [[nodiscard]] Vec<std::int64_t> operator()(const Vec<std::int64_t>& x) const {
    Vec<std::int64_t> y = translation;
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_translation) {
        y[i] += x[i];
      } else {
        y[i] += linear[i][0] * x[0] + linear[i][1] * x[1] + linear[i][2] * x[2];
      }
    }
    return y;
  }
};

/// The map of an element on points with coordinates of absolute value at most `most`; nothing if an image
/// might reach kFixedLimit. Requires: the denominator is a multiple of those of G's translations, 0 <= most <
/// kFixedLimit.
[[nodiscard]] std::optional<FixedMap> fixed_map(const Group& group, const Element& element,
                                                std::int64_t denominator, std::int64_t most);

}  // namespace flatdt::checker
