/// What the reference writes is what the definition-level oracle finds.
#include <gtest/gtest.h>

#include <sstream>

#include "flatdt/checker/input.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "for_all.hpp"
#include "judge.hpp"
#include "oracle/compare.hpp"
#include "oracle/voronoi.hpp"
#include "require.hpp"

namespace flatdt::property_tests {
namespace {

void equals_oracle(const Specimen& s) {
  const ref::Instance instance = instance_of(s);
  const ref::TriangulationResult result = triangulate(instance);
  std::istringstream instance_in(ref::write_instance(instance));
  const checker::Instance parsed = checker::parse_instance(instance_in, "instance");
  std::istringstream triangulation_in(ref::write_triangulation(result.triangulation, {}));
  const checker::Triangulation claimed =
      checker::parse_triangulation(triangulation_in, "triangulation", parsed);

  const oracle::Tessellation tessellation = oracle::delaunay_tessellation(parsed);
  const std::string difference = oracle::difference(parsed, tessellation, claimed);
  require(difference.empty(), "the oracle differs: " + difference);
  require(tessellation.representatives.size() == result.distinct_points, "the oracle counts other orbits");
  const oracle::Existence existence = oracle::carries_triangulation(tessellation);
  if (existence == oracle::Existence::yes) {
    require(!result.reason || result.reason->kind == ref::StayedInCover::Kind::not_invariant,
            "the manifold carries every triangulation of these points, but a cover was written");
  }
  require(existence != oracle::Existence::no || result.reason.has_value(),
          "the manifold carries no triangulation of these points, but one was written");
}

TEST(Agreement, PlaneEqualsTheOracle) {
  for_all({100, plane()}, equals_oracle);
}

TEST(Agreement, SpaceEqualsTheOracle) {
  for_all({15, space()}, equals_oracle);
}

}  // namespace
}  // namespace flatdt::property_tests
