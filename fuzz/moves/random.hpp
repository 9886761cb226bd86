/// The source of choices of a mutation: a function of the engine's seed alone.
#pragma once

#include <cstddef>
#include <cstdint>

#include "generators/split_mix.hpp"

namespace flatdt::fuzz {

class Random : public testing::SplitMix64 {
 public:
  using SplitMix64::SplitMix64;

  /// From 0 to bound - 1. Requires: bound > 0.
  int below(int bound) { return static_cast<int>(next() % static_cast<std::uint64_t>(bound)); }
  std::size_t index(std::size_t size) { return static_cast<std::size_t>(next() % size); }
  bool one_in(int n) { return below(n) == 0; }
};

}  // namespace flatdt::fuzz
