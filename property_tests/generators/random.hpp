/// Random choices for specimens, the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "flatdt/ref/exact.hpp"
#include "split_mix.hpp"

namespace flatdt::testing {

class Random : public SplitMix64 {
 public:
  using SplitMix64::SplitMix64;

  /// In [0, n), n > 0; uniform up to n / 2^64.
  std::uint64_t below(std::uint64_t n) { return next() % n; }
  /// In [low, high]. Requires: low <= high.
  long between(long low, long high) {
    return low + static_cast<long>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
  bool one_in(std::uint64_t n) { return below(n) == 0; }
  /// numerator / denominator, the numerator in [low, high].
  ref::Rational fraction(long low, long high, long denominator) {
    return {ref::Integer(between(low, high)), ref::Integer(denominator)};
  }
  template <class T>
  const T& of(const std::vector<T>& values) {
    return values[below(values.size())];
  }
  template <class T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }
};

}  // namespace flatdt::testing
