/// The cases of a campaign. Laws: a case is a function of the plan and its number alone, on every machine; so
/// shards and resumed campaigns meet the same cases.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "capabilities.hpp"
#include "draw.hpp"

namespace flatdt::campaign {

/// What cases are drawn from.
struct Plan {
  std::uint64_t seed = 1;
  std::vector<std::string> manifolds;  // not empty
  std::vector<std::string> families;   // not empty
  long min_points = 1;
  long max_points = 40;
  Capabilities capabilities;
};

/// All families: those of ref, small-grid, orbit-midpoints, and own_families().
[[nodiscard]] std::vector<std::string> all_families();

/// Case number `number`: manifold and family drawn evenly, the number of points evenly on a logarithmic
/// scale, then metric, coordinates and points; made to conform to the capabilities. It need not be accepted
/// by them.
[[nodiscard]] testing::Specimen draw_case(const Plan& plan, std::uint64_t number);

/// What shrinking may use: the plan's manifolds that the capabilities accept, simplest first.
[[nodiscard]] testing::Domain shrinking_domain(const Plan& plan);

}  // namespace flatdt::campaign
