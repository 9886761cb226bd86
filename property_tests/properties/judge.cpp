#include "judge.hpp"

#include <sstream>

#include "flatdt/checker/check.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "require.hpp"

namespace flatdt::property_tests {

checker::Verdict judge(const std::string& instance_text, const std::string& triangulation_text) {
  std::istringstream instance_in(instance_text);
  const checker::Instance instance = checker::parse_instance(instance_in, "instance");
  std::istringstream triangulation_in(triangulation_text);
  return checker::check(instance, checker::parse_triangulation(triangulation_in, "triangulation", instance));
}

checker::Verdict judge(const ref::Instance& instance, const ref::Triangulation& triangulation) {
  return judge(ref::write_instance(instance), ref::write_triangulation(triangulation, {}));
}

std::string summary(const checker::Verdict& verdict) {
  std::string text{to_string(verdict.outcome)};
  for (std::size_t i = 0; i < checker::kConditionCount; ++i) {
    const auto name = static_cast<checker::ConditionName>(i);
    if (verdict[name].status == checker::Status::holds) continue;
    text += ", " + std::string(to_string(name)) + " " + std::string(to_string(verdict[name].status));
  }
  return text + (verdict.reason.empty() ? "" : ": " + verdict.reason);
}

void require_verified(const ref::Instance& instance, const ref::Triangulation& triangulation) {
  const checker::Verdict verdict = judge(instance, triangulation);
  require(verdict.outcome == checker::Outcome::verified, "the checker says " + summary(verdict));
}

ref::TriangulationResult triangulate(const ref::Instance& instance,
                                     const ref::TriangulationOptions& options) {
  return ref::triangulate(instance, ref::analyse(instance), options);
}

}  // namespace flatdt::property_tests
