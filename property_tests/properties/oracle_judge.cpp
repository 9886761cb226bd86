#include "oracle_judge.hpp"

#include <sstream>

#include "flatdt/checker/input.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "oracle/compare.hpp"
#include "oracle/voronoi.hpp"
#include "require.hpp"

namespace flatdt::property_tests {

void require_equal_to_oracle(const ref::Instance& instance, const ref::TriangulationResult& result) {
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
  // The didicosm's choice in ties may be no choice of the manifold's.
  const bool invariant = !result.reason || result.reason->kind != ref::StayedInCover::Kind::not_invariant;
  require(existence != oracle::Existence::yes || !result.reason || !invariant,
          "the manifold carries every triangulation of these points, but a cover was written");
  require(existence != oracle::Existence::no || result.reason,
          "the manifold carries no triangulation of these points, but one was written");
}

}  // namespace flatdt::property_tests
