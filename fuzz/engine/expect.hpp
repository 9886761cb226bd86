/// How a fuzz target reports a defect.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace flatdt::fuzz {

/// Prints the law that does not hold and aborts: every engine takes that for a finding. Inputs are asked
/// thousands of laws: nothing is allocated.
inline void expect(bool holds, std::string_view law) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: a law does not hold: %.*s\n", static_cast<int>(law.size()), law.data());
  std::abort();
}

}  // namespace flatdt::fuzz
