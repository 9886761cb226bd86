/// How a fuzz target reports a defect.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace flatdt::fuzz {

/// Prints the law that does not hold and aborts: every engine takes that for a finding.
inline void expect(bool holds, const std::string& law) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: a law does not hold: %s\n", law.c_str());
  std::abort();
}

}  // namespace flatdt::fuzz
