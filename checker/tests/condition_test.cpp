// Every condition on hand-made inputs: the status of all conditions, the verdict, and witnesses recomputed.
// Letters: group, subgroup, (vertices cells paired opposite volume delaunay), (injective loop 2-cycle
// intersection), links, (connected euler orientable homology).
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "build.hpp"

namespace flatdt::checker::test {
namespace {

using enum ConditionName;

TEST(Conditions, GridsAreVerified) {
  expect(judge(grid_instance(3, 3), grid_triangulation(3, 3).str()), "hhs h hhhhhh hhhh h hhhh",
         Outcome::verified);
  expect(judge(grid_instance(5, 4), grid_triangulation(5, 4).str()), "hhs h hhhhhh hhhh h hhhh",
         Outcome::verified);
  expect(judge(cubic_point(), kuhn_triangulation(3).str()), "hhh h hhhhhh hhhh h hhhh", Outcome::verified);
  expect(judge(cubic_point(), kuhn_triangulation(4).str()), "hhh h hhhhhh hhhh h hhhh", Outcome::verified);
}

// Lifts, order of vertices and of cells, spare and repeated elements: none of them matters.
TEST(Conditions, AnyLiftAndOrderWillDo) {
  TriangulationText t;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      const auto v = [&](int dx, int dy, int k) { return grid_vertex(x + dx + 3 * k, y + dy - 6 * k, 3, 3); };
      t.cells.push_back({v(1, 1, x), v(0, 0, x), v(1, 0, x)});
      t.cells.insert(t.cells.begin(), {v(0, 1, y - 5), v(0, 0, y - 5), v(1, 1, y - 5)});
    }
  }
  t.extra_elements = {shift({100, 7}), shift({0, 0}), shift({0, 0})};
  expect(judge(grid_instance(3, 3), t.str()), "hhs h hhhhhh hhhh h hhhh", Outcome::verified);
}

TEST(Conditions, LiftsBeyondMachineIntegers) {
  TriangulationText t = grid_triangulation(3, 3);
  const std::string far = "1" + std::string(40, '0');
  for (auto& [point, element] : t.cells[4]) {
    std::istringstream in(element);
    std::string a, b, x, c, d, y;
    in >> a >> b >> x >> c >> d >> y;
    element = "1 0 " + Integer(Integer(far) + Integer(x)).get_str() + " 0 1 " + y;
  }
  expect(judge(grid_instance(3, 3), t.str()), "hhs h hhhhhh hhhh h hhhh", Outcome::verified);
  t.cells[4][0].second = shift({0, 0});  // now a cell of astronomical size: no limit, just wrong
  expect(judge(grid_instance(3, 3), t.str()), "hhs h hhfhfs hhfs s ssss", Outcome::refuted);
}

// A point listed twice, its second copy moved by the group, and cells using either index.
TEST(Conditions, RepeatedPoints) {
  TriangulationText t = grid_triangulation(3, 3);
  for (std::size_t c = 0; c < t.cells.size(); c += 2) {
    for (auto& [point, element] : t.cells[c]) {
      if (point != 4) continue;
      point = 9;  // = (1/3 + 2, 1/3 - 1): the lift (1/3, 1/3) + v is point 9 moved by v - (2, -1)
      const int x = element == shift({0, 0}) ? 0 : 1000;
      ASSERT_EQ(x, 0);
      element = shift({-2, 1});
    }
  }
  expect(judge(grid_instance(3, 3, "", "7/3 -2/3", 1), t.str()), "hhs h hhhhhh hhhh h hhhh",
         Outcome::verified);
}

// --- vertices.complete
TEST(Conditions, MissingPoint) {
  const Verdict v = judge(grid_instance(3, 3, "", "1/2 1/7", 1), grid_triangulation(3, 3).str());
  expect(v, "hhs h fhhhhs hhhh h hhhh", Outcome::refuted);
  EXPECT_EQ(witness(v, vertices_complete, "vertices"), "9");
  EXPECT_EQ(witness(v, vertices_complete, "expected"), "10");
  EXPECT_EQ(witness(v, vertices_complete, "point"), "9");
  EXPECT_EQ(witness(v, vertices_complete, "copies-of-point"), "0");
}

// In a covering every copy counts: Kuhn's triangulation of (2Z)^3, claimed for one point of the index-8
// sublattice's double cover, lacks no copy; with a second point of the instance it lacks all of that point's.
TEST(Conditions, MissingCopies) {
  const Verdict v = judge("flatdt-instance 1 dimension 3 manifold P1 points 2 0 0 0 1/2 1/3 1/4 ",
                          kuhn_triangulation(3).str());
  expect(v, "hhh h fhhhhs hhhh h hhhh", Outcome::refuted);
  EXPECT_EQ(witness(v, vertices_complete, "expected"), "54");
}

// --- cells.nondegenerate: the edge (0,0)-(1/3,0) split on its upper side only, and the gap filled by a flat
// cell.
TEST(Conditions, FlatCellInAGap) {
  TriangulationText t = grid_triangulation(3, 3);
  const auto a = grid_vertex(0, 0, 3, 3);
  const auto c = grid_vertex(1, 0, 3, 3);
  const auto x = grid_vertex(1, 1, 3, 3);
  const std::pair<std::size_t, std::string> m = {9, shift({0, 0})};
  t.cells[0] = {a, m, x};
  t.cells.push_back({m, c, x});
  t.cells.push_back({a, m, c});
  const Verdict v = judge(grid_instance(3, 3, "", "1/6 0", 1), t.str());
  expect(v, "hhs h hfhhhf hhhs s hhhh", Outcome::refuted);
  EXPECT_EQ(witness(v, cells_nondegenerate, "cell"), "19");
  EXPECT_EQ(witness(v, cells_nondegenerate, "cell-points"), "(0,0);(1/6,0);(1/3,0)");
}

TEST(Conditions, RepeatedVertexInACell) {
  TriangulationText t = grid_triangulation(3, 3);
  t.cells[5][1] = t.cells[5][0];
  const Verdict v = judge(grid_instance(3, 3), t.str());
  EXPECT_EQ(v[cells_nondegenerate].status, Status::fails);
  EXPECT_EQ(v[facets_paired].status, Status::fails);
  EXPECT_EQ(witness(v, facets_paired, "reason"), "cell-with-repeated-vertex");
  EXPECT_EQ(v.outcome, Outcome::refuted);
}

/// Its sides are occurrences: a facet with two others is not one that occurs exactly twice, whatever their
/// sides.
TEST(Conditions, SidesOfACellWithARepeatedVertexAreOccurrences) {
  const std::string folder = FLATDT_CORPORA "/regressions/";
  const auto text = [&](const char* name) {
    std::ifstream in(folder + name);
    EXPECT_TRUE(in) << name;
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const Verdict v =
      judge(text("sides-of-flattened-cells.instance"), text("sides-of-flattened-cells.triangulation"));
  expect(v, "hhh h fffhfs hhhs s ssss", Outcome::refuted);
}

// --- facets.paired
TEST(Conditions, MissingCell) {
  TriangulationText t = grid_triangulation(3, 3);
  t.cells.erase(t.cells.begin() + 7);
  const Verdict v = judge(grid_instance(3, 3), t.str());
  expect(v, "hhs h hhfhfs hhhs s ssss", Outcome::refuted);
  EXPECT_EQ(witness(v, facets_paired, "occurrences"), "1");
  EXPECT_EQ(witness(v, volume_exact, "volume-of-cells"), "17/18");
  EXPECT_EQ(witness(v, volume_exact, "expected"), "1");
}

TEST(Conditions, RepeatedCell) {
  TriangulationText t = grid_triangulation(3, 3);
  t.cells.push_back(t.cells[3]);
  const Verdict v = judge(grid_instance(3, 3), t.str());
  expect(v, "hhs h hhfhfs hhhs s ssss", Outcome::refuted);
  EXPECT_EQ(witness(v, facets_paired, "occurrences"), "3");
}

// One cell replaced by a translate of another: volumes and cell numbers are right, facets are not.
TEST(Conditions, ReplacedCell) {
  TriangulationText t = grid_triangulation(3, 3);
  t.cells[3] = t.cells[5];
  expect(judge(grid_instance(3, 3), t.str()), "hhs h hhfhhs hhhs s ssss", Outcome::refuted);
}

TEST(Conditions, NoCells) {
  const Verdict v = judge(grid_instance(3, 3), "flatdt-triangulation 1 elements 0 cells 0 ");
  expect(v, "hhs h fhhhfs hhhs h hhhf", Outcome::refuted);
}

TEST(Conditions, OneCellTwice) {
  TriangulationText t;
  t.cells = {grid_triangulation(3, 3).cells[0], grid_triangulation(3, 3).cells[0]};
  // Each facet twice, from one side; as a set it is one cell, whose vertices' links are edges.
  const Verdict v = judge(grid_instance(3, 3), t.str());
  expect(v, "hhs h fhhffs hhhs f hfhf", Outcome::refuted);

  TriangulationText space = kuhn_triangulation(3);
  space.cells = {space.cells[7], space.cells[7]};
  const Verdict in_space = judge(cubic_point(), space.str());
  expect(in_space, "hhh h fhhffs hhhs f hfhf", Outcome::refuted);
  EXPECT_EQ(witness(in_space, links_spheres, "reason"), "an-edge-of-the-link-has-not-two-triangles");
}

// --- delaunay.empty: a skew metric wants the other diagonals.
TEST(Conditions, WrongDiagonals) {
  expect(judge(grid_instance(3, 3, "1 -1/5 1"), grid_triangulation(3, 3).str()), "hhs h hhhhhh hhhh h hhhh",
         Outcome::verified);
  const Verdict v = judge(grid_instance(3, 3, "1 1/5 1"), grid_triangulation(3, 3).str());
  expect(v, "hhs h hhhhhf hhhh h hhhh", Outcome::refuted);
  EXPECT_GT(Rational(witness(v, delaunay_empty, "insphere")), 0);
}

// A difference of 10^-300 decides; zero on the other side.
TEST(Conditions, DelaunayIsExact) {
  expect(judge(grid_instance(3, 3, "1 -1e-300 1"), grid_triangulation(3, 3).str()),
         "hhs h hhhhhh hhhh h hhhh", Outcome::verified);
  const Verdict v = judge(grid_instance(3, 3, "1 1e-300 1"), grid_triangulation(3, 3).str());
  expect(v, "hhs h hhhhhf hhhh h hhhh", Outcome::refuted);
}

TEST(Conditions, WrongMetricIn3D) {
  const std::string head = "flatdt-instance 1 dimension 3 manifold P1 metric ";
  expect(judge(head + "1 -1/9 -1/9 1 -1/9 1 points 1 0 0 0 ", kuhn_triangulation(3).str()),
         "hhh h hhhhhh hhhh h hhhh", Outcome::verified);
  expect(judge(head + "1 1/9 -1/9 1 -1/9 1 points 1 0 0 0 ", kuhn_triangulation(3).str()),
         "hhh h hhhhhf hhhh h hhhh", Outcome::refuted);
}

// --- simplices.injective and skeleton.no-loop: one point of the torus.
TEST(Conditions, OnePointOfTheTorus) {
  const Verdict v = judge(grid_instance(1, 1), grid_triangulation(1, 1).str());
  expect(v, "hhs h hhhhhh ffff h hhhh", Outcome::refuted);
}

// --- skeleton.no-2-cycle and complex.intersection alone: no loop, but double edges.
TEST(Conditions, FourPointsOfTheTorus) {
  const Verdict v = judge(grid_instance(2, 2), grid_triangulation(2, 2).str());
  expect(v, "hhs h hhhhhh hhff h hhhh", Outcome::refuted);
  EXPECT_NE(witness(v, skeleton_no_2_cycle, "edge"), witness(v, skeleton_no_2_cycle, "other-edge"));
  expect(judge(cubic_point(), kuhn_triangulation(2).str()), "hhh h hhhhhh hhff h hhhh", Outcome::refuted);
}

// One column has loops and double edges, two columns double edges only.
TEST(Conditions, NarrowTori) {
  const Verdict v = judge(grid_instance(1, 5), grid_triangulation(1, 5).str());
  expect(v, "hhs h hhhhhh ffff h hhhh", Outcome::refuted);
  expect(judge(grid_instance(2, 5), grid_triangulation(2, 5).str()), "hhs h hhhhhh hhff h hhhh",
         Outcome::refuted);
}

// The Klein bottle itself: m x n grid with rows glued by the glide, diagonals mirrored in every other half.
TEST(Conditions, KleinBottleGrid) {
  constexpr int m = 3;
  constexpr int n = 3;
  std::string instance = "flatdt-instance 1 dimension 2 manifold pg points 9 ";
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < m; ++x) instance += std::to_string(x) + "/3 " + std::to_string(y) + "/6 ";
  }
  const auto vertex = [&](int x, int y) {
    const int q = floor_div(y, n);
    const int mirror = q % 2 == 0 ? 1 : -1;
    const int i = mirror * x - m * floor_div(mirror * x, m);
    const int s = (x - mirror * i) / m;
    const std::string glide =
        std::to_string(mirror) + " 0 " + std::to_string(s) + " 0 1 " + std::to_string(q) + "/2 ";
    return std::pair(static_cast<std::size_t>(i + m * (y - q * n)), glide);
  };
  TriangulationText t;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < m; ++x) {
      t.cells.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)});
      t.cells.push_back({vertex(x, y), vertex(x, y + 1), vertex(x + 1, y + 1)});
    }
  }
  expect(judge(instance, t.str()), "hhh h hhhhhh hhhh h hhhh", Outcome::verified);
  // Lifted by odd powers of the glide, the cells are mirrored: still the same triangulation.
  TriangulationText moved;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < m; ++x) {
      const auto glided = [&](int dx, int dy) { return vertex(-(x + dx), y + dy + n * (2 * x + 1)); };
      moved.cells.push_back({glided(0, 0), glided(1, 0), glided(1, 1)});
      moved.cells.push_back({vertex(x, y), vertex(x, y + 1), vertex(x + 1, y + 1)});
    }
  }
  expect(judge(instance, moved.str()), "hhh h hhhhhh hhhh h hhhh", Outcome::verified);
  // In the torus cover (translations only), the same cells are half of what is needed.
  t.subgroup = {shift({1, 0}), shift({0, 1})};
  const Verdict half = judge(instance, t.str());
  EXPECT_EQ(half.outcome, Outcome::refuted);
  EXPECT_EQ(witness(half, volume_exact, "expected"), "1");
  EXPECT_EQ(witness(half, volume_exact, "volume-of-cells"), "1/2");
}

}  // namespace
}  // namespace flatdt::checker::test
