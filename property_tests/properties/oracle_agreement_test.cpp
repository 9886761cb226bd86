/// What the reference writes is what the definition-level oracle finds.
#include <gtest/gtest.h>

#include "for_all.hpp"
#include "judge.hpp"
#include "oracle_judge.hpp"

namespace flatdt::property_tests {
namespace {

void equals_oracle(const Specimen& s) {
  const ref::Instance instance = instance_of(s);
  require_equal_to_oracle(instance, triangulate(instance));
}

TEST(OracleAgreement, Plane) {
  for_all({100, plane()}, equals_oracle);
}
TEST(OracleAgreement, Space) {
  for_all({10, space()}, equals_oracle);
}

}  // namespace
}  // namespace flatdt::property_tests
