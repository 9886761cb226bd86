/// How a property says that it does not hold: by an exception, so that the failing input can be shrunk.
/// (Expectations of GoogleTest do not interrupt a property, and nothing would shrink.)
#pragma once

#include <stdexcept>
#include <string>

namespace flatdt::property_tests {

class Violation : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline void require(bool holds, const char* law) {
  if (!holds) throw Violation(law);
}
inline void require(bool holds, const std::string& law) {
  if (!holds) throw Violation(law);
}

}  // namespace flatdt::property_tests
