// Group elements as both parsers read them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "flatdt/checker/exact.hpp"
#include "lexer.hpp"

namespace flatdt::checker {

/// Reads "COUNT elements" with at least `least` and at most 10,000 of them.   Cost: memory as read, not as
/// claimed.
[[nodiscard]] inline std::vector<Seitz> parse_generators(Lexer& lexer, int dimension, std::uint64_t least) {
  constexpr std::uint64_t kMaxGenerators = 10'000;
  const std::uint64_t n = lexer.count("the number of generators", least, kMaxGenerators);
  const auto d = static_cast<std::size_t>(dimension);
  constexpr std::uint64_t kUsual = 16;
  std::vector<Seitz> generators;
  generators.reserve(std::min(n, kUsual));  // GMP's numbers are copied where a vector grows
  for (std::uint64_t i = 0; i < n; ++i) {
    Seitz& g = generators.emplace_back();
    for (std::size_t row = 0; row < d; ++row) {
      for (std::size_t k = 0; k < d; ++k) lexer.number("an entry of a generator", g.linear[row][k]);
      lexer.number("an entry of a generator", g.translation[row]);
    }
  }
  return generators;
}

}  // namespace flatdt::checker
