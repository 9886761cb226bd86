/// Every set of at most four points of a grid, modulo symmetry, on every manifold: VERIFIED, and for some of
/// them compared with the definition-level oracle. FLATDT_SMALL_WORLDS=large takes finer grids.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <iostream>

#include "flatdt/ref/instance_format.hpp"
#include "judge.hpp"
#include "oracle_judge.hpp"
#include "require.hpp"
#include "small_world.hpp"

namespace flatdt::property_tests {
namespace {

struct Grid {
  const char* manifold;
  std::array<long, 3> divisions;
  std::array<long, 3> large_divisions;
  /// Every how manieth point set is given to the oracle.
  std::size_t oracle_stride;
  friend std::ostream& operator<<(std::ostream& out, const Grid& grid) { return out << grid.manifold; }
};

/// Each grid is mapped to itself by its group.
const std::vector<Grid>& grids() {
  static const std::vector<Grid> kGrids = {
      {"torus", {5, 5, 1}, {10, 10, 1}, 10},           {"klein-bottle", {4, 6, 1}, {8, 8, 1}, 10},
      {"torocosm", {3, 3, 3}, {4, 4, 4}, 10},          {"dicosm", {2, 2, 2}, {4, 4, 4}, 10},
      {"tricosm", {2, 2, 3}, {3, 3, 3}, 10},           {"tetracosm", {2, 2, 4}, {3, 3, 4}, 10},
      {"hexacosm", {2, 2, 6}, {3, 3, 6}, 10},          {"didicosm", {2, 2, 4}, {4, 4, 4}, 10},
      {"first-amphicosm", {2, 2, 2}, {4, 4, 4}, 10},   {"second-amphicosm", {2, 2, 2}, {4, 4, 4}, 10},
      {"first-amphidicosm", {2, 2, 4}, {4, 4, 4}, 10}, {"second-amphidicosm", {2, 2, 4}, {4, 4, 4}, 10},
  };
  return kGrids;
}

bool is_large() {
  const char* setting = std::getenv("FLATDT_SMALL_WORLDS");
  return setting != nullptr && std::string(setting) == "large";
}

class SmallWorlds : public ::testing::TestWithParam<Grid> {};

TEST_P(SmallWorlds, EveryPointSetIsVerified) {
  const Grid& grid = GetParam();
  const std::clock_t start = std::clock();
  const SmallWorld world(grid.manifold, is_large() ? grid.large_divisions : grid.divisions);
  std::size_t instances = 0, on_manifold = 0, compared = 0;
  std::cout << grid.manifold << ": " << world.orbits() << " orbits, " << world.symmetries()
            << " symmetries; sets of 1, 2, 3, 4 points:";
  for (std::size_t size = 1; size <= 4; ++size) {
    const auto sets = world.point_sets(size);
    ASSERT_EQ(sets.size(), world.count_by_burnside(size)) << "enumeration and Burnside disagree";
    std::cout << " " << sets.size();
    for (const SmallWorld::PointSet& set : sets) {
      const ref::Instance instance = world.instance(set);
      const ref::TriangulationResult result = triangulate(instance);
      ASSERT_NO_THROW(require_verified(instance, result.triangulation)) << write_instance(instance);
      if (!result.reason) ++on_manifold;
      if (instances++ % grid.oracle_stride == 0) {
        ++compared;
        ASSERT_NO_THROW(require_equal_to_oracle(instance, result)) << write_instance(instance);
      }
    }
  }
  // A simplicial torus has at least 7 vertices, a Klein bottle 8, a 3-manifold that is no sphere more than 4.
  EXPECT_EQ(on_manifold, 0U);
  std::cout << "; " << instances << " instances, as many by Burnside's lemma; " << compared
            << " compared with the oracle; " << static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC
            << " s\n";
}

INSTANTIATE_TEST_SUITE_P(Grids, SmallWorlds, ::testing::ValuesIn(grids()), [](const auto& parameter) {
  std::string name = parameter.param.manifold;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
});

/// The classes of the 2 x 2 grid of the square torus by hand: 1 point; 2 points in a row or column, or
/// diagonal; 3 points; 4 points.
TEST(SmallWorld, ClassesCountedByHand) {
  const SmallWorld world("torus", {2, 2, 1});
  EXPECT_EQ(world.orbits(), 4U);
  EXPECT_EQ(world.symmetries(), 8U);
  EXPECT_EQ(world.point_sets(1).size(), 1U);
  EXPECT_EQ(world.point_sets(2).size(), 2U);
  EXPECT_EQ(world.point_sets(3).size(), 1U);
  EXPECT_EQ(world.point_sets(4).size(), 1U);
}

}  // namespace
}  // namespace flatdt::property_tests
