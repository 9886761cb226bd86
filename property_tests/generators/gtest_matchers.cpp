#include "flatdt/testing/gtest_matchers.hpp"

#include <ostream>
#include <stdexcept>
#include <utility>

namespace flatdt::testing {

IsDelaunayTriangulationOf::IsDelaunayTriangulationOf(InstanceText instance)
    : instance_(std::move(instance)) {}

bool IsDelaunayTriangulationOf::MatchAndExplain(const TriangulationText& triangulation,
                                                std::ostream* explanation) const {
  const checker::Verdict verdict = judge(instance_, triangulation);
  const bool verified = verdict.outcome == checker::Outcome::verified;
  if (explanation != nullptr) *explanation << (verified ? "VERIFIED" : explain(verdict));
  return verified;
}

void IsDelaunayTriangulationOf::DescribeTo(std::ostream* out) const {
  *out << "is a Delaunay triangulation of the instance\n" << instance_.text();
}

void IsDelaunayTriangulationOf::DescribeNegationTo(std::ostream* out) const {
  *out << "is not a Delaunay triangulation of the instance\n" << instance_.text();
}

ViolatesCondition::ViolatesCondition(const std::string& condition, InstanceText instance)
    : instance_(std::move(instance)) {
  for (std::size_t i = 0; i < checker::kConditionCount; ++i) {
    condition_ = static_cast<checker::ConditionName>(i);
    if (to_string(condition_) == condition) return;
  }
  throw std::invalid_argument("the checker has no condition \"" + condition + "\"");
}

bool ViolatesCondition::MatchAndExplain(const TriangulationText& triangulation,
                                        std::ostream* explanation) const {
  const checker::Verdict verdict = judge(instance_, triangulation);
  if (explanation != nullptr) {
    const std::string text = explain(verdict);
    *explanation << to_string(condition_) << " " << to_string(verdict[condition_].status) << "; "
                 << (text.empty() ? "VERIFIED" : text);
  }
  return verdict[condition_].status == checker::Status::fails;
}

void ViolatesCondition::DescribeTo(std::ostream* out) const {
  *out << "violates " << to_string(condition_) << " of the instance\n" << instance_.text();
}

void ViolatesCondition::DescribeNegationTo(std::ostream* out) const {
  *out << "does not violate " << to_string(condition_) << " of the instance\n" << instance_.text();
}

::testing::AssertionResult is_delaunay_triangulation(const TriangulationText& triangulation,
                                                     const InstanceText& instance) {
  const std::string text = explain(instance, triangulation);
  return text.empty() ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << text;
}

}  // namespace flatdt::testing
