/// What the reference writes, the checker proves.
#include <gtest/gtest.h>

#include "for_all.hpp"
#include "judge.hpp"

namespace flatdt::property_tests {
namespace {

void is_verified(const Specimen& s) {
  const ref::Instance instance = instance_of(s);
  require_verified(instance, triangulate(instance).triangulation);
}

TEST(Agreement, PlaneIsVerified) {
  for_all({200, plane()}, is_verified);
}

TEST(Agreement, ManyPointsOfThePlaneAreVerified) {
  Domain domain = plane();
  domain.max_points_in_plane = 120;
  domain.max_stretch_in_plane = 3;
  for_all({30, domain}, is_verified);
}

TEST(Agreement, SpaceIsVerified) {
  for_all({30, space()}, is_verified);
}

/// One seed of the day, printed, on everything.
TEST(FreshSeed, EverythingIsVerified) {
  Domain domain = domain_of(testing::all_manifolds());
  for_all({20, domain}, is_verified);
}

}  // namespace
}  // namespace flatdt::property_tests
