// Complexes in which every facet is paired and which are no triangulation all the same: folded, doubled,
// covering twice. What the single conditions see of them.   Letters as in condition_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

#include "build.hpp"

namespace flatdt::checker::test {
namespace {

using enum ConditionName;

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

TEST(Folds, DoubledStrip) {
  const Verdict v = judge(grid_instance(7, 2), doubled_strip(7).str());
  expect(v, "hhs h hhhfhf hhhs h hhhh", Outcome::refuted);
  EXPECT_NE(witness(v, facets_opposite, "determinant"), "");
  EXPECT_EQ(witness(v, facets_opposite, "determinant")[0] == '-',
            witness(v, facets_opposite, "other-determinant")[0] == '-');
}

// The same strip in the Klein bottle of height 1/2: the complex is a torus, the manifold is not.
TEST(Folds, DoubledStripInTheKleinBottle) {
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
TEST(Folds, DoubledSlabInTheDicosm) {
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
TEST(Folds, TwoSheets) {
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

// Two sheets in space that share the edges in one direction: the links are two spheres that touch twice, V -
// E + F = 2.
TEST(Folds, TwoSheetsInSpaceSharingEdges) {
  TriangulationText t = kuhn_triangulation(7);
  const std::size_t n = t.cells.size();
  for (std::size_t c = 0; c < n; ++c) {
    auto cell = t.cells[c];
    for (auto& [point, element] : cell) {  // (x, y, z) -> (3x + 4y, 2x + 3y, z)
      std::istringstream in(element);
      std::array<int, 12> e{};
      for (int& entry : e) in >> entry;
      element = shift({3 * e[3] + 4 * e[7], 2 * e[3] + 3 * e[7], e[11]});
    }
    t.cells.push_back(cell);
  }
  const Verdict v = judge(cubic_point(), t.str());
  expect(v, "hhh h hhhhff hhhs f fhhf", Outcome::refuted);
  EXPECT_EQ(witness(v, links_spheres, "reason"), "the-link-is-not-connected");
}

// The cone over a 3 x 3 torus from two apexes: facets are paired, but the apexes' links are tori.
TEST(Folds, SuspensionOfATorus) {
  std::string instance = "flatdt-instance 1 dimension 3 manifold P1 points 11 1/2 1/3 1/5 1/7 3/4 8/9 ";
  for (int i = 0; i < 9; ++i) {
    instance += std::to_string(3 * i * i % 11) + "/11 " + std::to_string(5 * i % 13) + "/13 " +
                std::to_string(i * i * i % 17) + "/17 ";
  }
  TriangulationText t;
  for (const auto& triangle : grid_triangulation(3, 3).cells) {
    for (const std::size_t apex : {0, 1}) {
      TriangulationText::CellVertices cell = {{apex, shift({0, 0, 0})}};
      for (const auto& [point, element] : triangle) cell.emplace_back(point + 2, shift({0, 0, 0}));
      t.cells.push_back(cell);
    }
  }
  const Verdict v = judge(instance, t.str());
  EXPECT_EQ(v[cells_nondegenerate].status, Status::holds);
  EXPECT_EQ(v[facets_paired].status, Status::holds);
  EXPECT_EQ(v[links_spheres].status, Status::fails);
  EXPECT_EQ(witness(v, links_spheres, "reason"), "the-Euler-number-of-the-link-is-not-2");
  EXPECT_EQ(witness(v, topology_euler, "faces-by-dimension"), "11,45,72,36");
  EXPECT_EQ(witness(v, topology_homology, "complex"), "0");
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

TEST(Folds, ConnectedDoubleCoverIsRefutedByVolumeLinksAndEuler) {
  const Verdict v = judge(cubic_point(), checkerboard().str());
  expect(v, "hhh h hhhhfs hhhs f hfhh", Outcome::refuted);
  EXPECT_EQ(witness(v, volume_exact, "volume-of-cells"), "54");
  EXPECT_EQ(witness(v, volume_exact, "expected"), "27");
}

}  // namespace
}  // namespace flatdt::checker::test
