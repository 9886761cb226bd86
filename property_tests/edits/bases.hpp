/// Which valid triangulations are edited.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flatdt::edits {

struct Recipe {
  std::string manifold;
  std::string family;
  long points;
  std::string metric;
  std::uint64_t seed;
};

/// quick: few and small ones, the same kinds of edit. Otherwise `rounds` times all families on all manifolds.
[[nodiscard]] std::vector<Recipe> recipes(bool quick, std::size_t rounds, std::uint64_t seed);

}  // namespace flatdt::edits
