// Every condition on hand-made inputs: the status of all conditions, the verdict, and witnesses recomputed.
// Letters: group, subgroup, (vertices cells paired opposite volume delaunay), (injective loop 2-cycle
// intersection), links, (connected euler orientable homology).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "build.hpp"

namespace flatdt::checker::test {
namespace {

using enum ConditionName;

void expect(const Verdict& verdict, const std::string& expected, Outcome outcome) {
  EXPECT_EQ(statuses(verdict), expected) << verdict.reason;
  EXPECT_EQ(verdict.outcome, outcome) << verdict.reason;
}

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
}

// --- facets.opposite: the strip 0 <= y <= 1/2 covered twice by different triangles, the rest not at all.
// Every facet occurs twice, the volume is right, and as a complex it is a torus; only the folds at the
// strip's edges are wrong.
TriangulationText doubled_strip(int m) {
  TriangulationText t;
  for (const int slant : {0, 2}) {
    for (int x = 0; x < m; ++x) {
      const auto v = [&](int dx, int y) { return grid_vertex(x + dx, y, m, 2); };
      t.cells.push_back({v(0, 0), v(1, 0), v(slant + 1, 1)});
      t.cells.push_back({v(0, 0), v(slant, 1), v(slant + 1, 1)});
    }
  }
  return t;
}

TEST(Conditions, DoubledStrip) {
  const Verdict v = judge(grid_instance(7, 2), doubled_strip(7).str());
  expect(v, "hhs h hhhfhf hhhs h hhhh", Outcome::refuted);
  EXPECT_NE(witness(v, facets_opposite, "determinant"), "");
  EXPECT_EQ(witness(v, facets_opposite, "determinant")[0] == '-',
            witness(v, facets_opposite, "other-determinant")[0] == '-');
}

// The same strip in the Klein bottle of height 1/2: the complex is a torus, the manifold is not.
TEST(Conditions, DoubledStripInTheKleinBottle) {
  TriangulationText t = doubled_strip(7);
  std::string instance = "flatdt-instance 1 dimension 2 manifold klein-bottle points 14 ";
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 7; ++x) instance += std::to_string(x) + "/7 " + std::to_string(y) + "/4 ";
  }
  const Verdict v = judge(instance, t.str());
  expect(v, "hhh h hhhfhf hhhs h hhff", Outcome::refuted);
  EXPECT_EQ(witness(v, topology_orientable, "complex"), "orientable");
  EXPECT_EQ(witness(v, topology_orientable, "manifold"), "not-orientable");
  EXPECT_EQ(witness(v, topology_homology, "complex"), "Z^2");
  EXPECT_EQ(witness(v, topology_homology, "manifold"), "Z+Z/2");
}

// One dimension up, in the dicosm of height 1/2: the doubled slab is a 3-torus; connected, orientable, Euler
// number 0.
TEST(Conditions, DoubledSlabInTheDicosm) {
  constexpr int m = 7;
  std::string instance = "flatdt-instance 1 dimension 3 manifold dicosm points 98 ";
  for (int p = 0; p < 98; ++p) {
    instance +=
        std::to_string(p % 7) + "/7 " + std::to_string(p / 7 % 7) + "/7 " + std::to_string(p / 49) + "/4 ";
  }
  TriangulationText t;
  const std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (const int slant : {0, 2}) {
    for (int x = 0; x < m * m; ++x) {
      for (const auto& order : orders) {
        std::array<int, 3> v = {x % m, x / m, 0};
        const auto vertex = [&] {
          const int px = v[0] + slant * v[2];
          const int py = v[1] + slant * v[2];
          const int ax = floor_div(px, m);
          const int ay = floor_div(py, m);
          return std::pair(static_cast<std::size_t>((px - ax * m) + m * (py - ay * m) + m * m * v[2]),
                           shift({ax, ay, 0}));
        };
        TriangulationText::CellVertices cell = {vertex()};
        for (const int axis : order) {
          ++v[static_cast<std::size_t>(axis)];
          cell.push_back(vertex());
        }
        t.cells.push_back(cell);
      }
    }
  }
  const Verdict v = judge(instance, t.str());
  expect(v, "hhh h hhhfhf hhhs h hhhf", Outcome::refuted);
  EXPECT_EQ(witness(v, topology_homology, "complex"), "Z^3");
  EXPECT_EQ(witness(v, topology_homology, "manifold"), "Z+Z/2+Z/2");
}

// --- volume.exact: two sheets with no face but the vertices in common. Everything local holds on each sheet.
TEST(Conditions, TwoSheets) {
  TriangulationText t = grid_triangulation(7, 7);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 7; ++x) {
      // The unimodular image of the grid under (2,1), (1,1): cells (0,0), (2,1), (3,2) and (0,0), (1,1),
      // (3,2); its edges (2,1), (1,1), (3,2) share (1,1) with the first sheet, hence the other image (3,1),
      // (2,1), (5,2).
      const auto v = [&](int dx, int dy) { return grid_vertex(x + dx, y + dy, 7, 7); };
      t.cells.push_back({v(0, 0), v(3, 1), v(5, 2)});
      t.cells.push_back({v(0, 0), v(2, 1), v(5, 2)});
    }
  }
  const Verdict v = judge(grid_instance(7, 7), t.str());
  EXPECT_EQ(v[facets_paired].status, Status::holds);
  EXPECT_EQ(v[facets_opposite].status, Status::holds);
  EXPECT_EQ(v[volume_exact].status, Status::fails);
  EXPECT_EQ(witness(v, volume_exact, "volume-of-cells"), "2");
  EXPECT_EQ(v[links_spheres].status, Status::fails);
  EXPECT_EQ(witness(v, links_spheres, "reason"), "the-link-is-not-connected");
  EXPECT_EQ(v[topology_connected].status, Status::fails);
  EXPECT_EQ(witness(v, topology_connected, "components"), "2");
  EXPECT_EQ(v[topology_euler].status, Status::fails);
  EXPECT_EQ(witness(v, topology_euler, "faces-by-dimension"), "49,294,196");
  EXPECT_EQ(v.outcome, Outcome::refuted);
}

// The connected double cover of DESIGN.md, section 6: cubes of Z^3 cut into five tetrahedra, in two mirror
// images like a checkerboard, and the same with the colours exchanged; all of it claimed modulo (3Z)^3, which
// exchanges them.
TriangulationText checkerboard() {
  TriangulationText t;
  t.subgroup = {shift({3, 0, 0}), shift({0, 3, 0}), shift({0, 0, 3})};
  for (int c = 0; c < 27; ++c) {
    for (const int colour : {0, 1}) {
      const std::vector<int> o = {c % 3, c / 3 % 3, c / 9};
      const auto corner = [&](int bits) {
        return std::pair(std::size_t{0},
                         shift({o[0] + (bits & 1), o[1] + (bits >> 1 & 1), o[2] + (bits >> 2 & 1)}));
      };
      const int flip = colour == 0 ? 0 : 7;  // 0,3,5,6 and 7,4,2,1 are the two inscribed tetrahedra
      t.cells.push_back({corner(0 ^ flip), corner(3 ^ flip), corner(5 ^ flip), corner(6 ^ flip)});
      for (const int apex : {1, 2, 4, 7}) {
        TriangulationText::CellVertices cell = {corner(apex ^ flip)};
        for (const int other : {0, 3, 5, 6}) {
          if ((other ^ apex) != 7) cell.push_back(corner(other ^ flip));
        }
        t.cells.push_back(cell);
      }
    }
  }
  return t;
}

TEST(Conditions, ConnectedDoubleCoverIsRefutedByVolumeLinksAndEuler) {
  const Verdict v = judge(cubic_point(), checkerboard().str());
  expect(v, "hhh h hhhhfs hhhs f hfhh", Outcome::refuted);
  EXPECT_EQ(witness(v, volume_exact, "volume-of-cells"), "54");
  EXPECT_EQ(witness(v, volume_exact, "expected"), "27");
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
