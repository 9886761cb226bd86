/// Pseudo-random 64-bit numbers: a counter in steps of the golden ratio, mixed by two rounds of
/// xor-shift-multiply. Integer arithmetic modulo 2^64 only, so the same on every machine; the distributions
/// of the standard library are not. Source: SplitMix64 [SteeleLeaFlood14].
#pragma once

#include <cstdint>

namespace flatdt::ref {

class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_;
};

}  // namespace flatdt::ref
