/// Which laws an input is asked. Those that cost much more than the rest are asked of one input in so many,
/// chosen by a hash of its bytes: an input is always asked the same, and none is left out for being slow.
#pragma once

#include <cstdint>
#include <span>

namespace flatdt::fuzz {

/// Whether every input is asked every law: always so in the plain programs that replay inputs, and with an
/// engine where the environment has FLATDT_FUZZ_ALL_LAWS (to minimise what broke a law that is seldom asked).
[[nodiscard]] bool asks_all_laws();

/// Whether the law with this number is asked of the input: of one in `n`, for each law others.
[[nodiscard]] inline bool is_asked(std::span<const std::uint8_t> input, std::uint64_t law, std::uint64_t n) {
  if (asks_all_laws()) return true;
  std::uint64_t hash = 0xcbf29ce484222325U + law;  // FNV-1a
  for (const std::uint8_t byte : input) hash = (hash ^ byte) * 0x100000001b3U;
  return (hash ^ (hash >> 32)) % n == 0;
}

}  // namespace flatdt::fuzz
