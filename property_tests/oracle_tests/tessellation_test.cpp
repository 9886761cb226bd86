/// The oracle on cases computed by hand, and on the table of corpora/adversarial.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>

#include "fixture.hpp"
#include "oracle/group.hpp"
#include "oracle/hull.hpp"
#include "oracle/orbit_points.hpp"
#include "oracle/polytope.hpp"
#include "oracle/voronoi.hpp"

namespace flatdt::oracle {
namespace {

using oracle_tests::read_instance;
using oracle_tests::stems;
using oracle_tests::text_of;
using oracle_tests::with;

Rational q(const char* text) {
  Rational value(text);
  value.canonicalize();
  return value;
}

checker::Instance instance(const std::string& body) {
  return read_instance("flatdt-instance 1 " + body + "\n");
}

/// How often the tessellation has a cell with this squared radius and number of points.
std::map<std::pair<Rational, std::size_t>, int> census(const Tessellation& tessellation) {
  std::map<std::pair<Rational, std::size_t>, int> count;
  for (const DelaunayCell& cell : tessellation.cells) ++count[{cell.squared_radius, cell.points.size()}];
  return count;
}

using Census = std::map<std::pair<Rational, std::size_t>, int>;

TEST(Tessellation, SquareTorusOnePoint) {
  const Tessellation t = delaunay_tessellation(instance("dimension 2 manifold torus points 1 1/3 1/5"));
  EXPECT_EQ(census(t), (Census{{{q("1/2"), 4}, 1}}));
  ASSERT_EQ(t.cells.size(), 1U);
  EXPECT_EQ(t.cells[0].centre, (Vector{q("5/6"), q("7/10"), 0}));
  EXPECT_EQ(t.cells[0].points[0].position, (Vector{q("1/3"), q("1/5"), 0}));
  EXPECT_EQ(t.cells[0].points[3].position, (Vector{q("4/3"), q("6/5"), 0}));
  EXPECT_EQ(t.cells[0].points[3].element.translation, (Vector{1, 1, 0}));
  EXPECT_TRUE(t.has_ties());
  EXPECT_EQ(carries_triangulation(t), Existence::no);  // the sides of the square are loops
}

TEST(Tessellation, HexagonalTorusOnePoint) {
  const Tessellation t =
      delaunay_tessellation(instance("dimension 2 manifold torus metric 1 -1/2 1 points 1 0 0"));
  EXPECT_EQ(census(t), (Census{{{q("1/3"), 3}, 2}}));
  EXPECT_FALSE(t.has_ties());
  EXPECT_EQ(carries_triangulation(t), Existence::no);
}

TEST(Tessellation, KleinBottleOnePoint) {
  // The orbit of (0, 0) is the lattice of 1 by 1/2 rectangles.
  EXPECT_EQ(census(delaunay_tessellation(instance("dimension 2 manifold klein-bottle points 1 0 0"))),
            (Census{{{q("5/16"), 4}, 1}}));
  // That of (1/4, 0) is a square lattice of side sqrt(1/2).
  EXPECT_EQ(census(delaunay_tessellation(instance("dimension 2 manifold klein-bottle points 1 1/4 0"))),
            (Census{{{q("1/4"), 4}, 1}}));
  // In general position: the triangles (1/10,1/5) (-1/10,7/10) (9/10,7/10) and (1/10,1/5) (11/10,1/5)
  // (9/10,7/10), with centres (2/5,61/100) and (3/5,29/100).
  const Tessellation t =
      delaunay_tessellation(instance("dimension 2 manifold klein-bottle points 1 1/10 1/5"));
  EXPECT_EQ(census(t), (Census{{{q("2581/10000"), 3}, 2}}));
  EXPECT_EQ(carries_triangulation(t), Existence::no);
}

TEST(Tessellation, CubicThreeTorusOnePoint) {
  const Tessellation t = delaunay_tessellation(instance("dimension 3 manifold torocosm points 1 0 0 0"));
  EXPECT_EQ(census(t), (Census{{{q("3/4"), 8}, 1}}));
  EXPECT_EQ(t.cells.at(0).centre, (Vector{q("1/2"), q("1/2"), q("1/2")}));
}

TEST(Tessellation, FaceCentredCubicLattice) {
  // Two regular tetrahedra and an octahedron with edges of length 1.
  const Tessellation t = delaunay_tessellation(
      instance("dimension 3 manifold torocosm metric 1 1/2 1/2 1 1/2 1 points 1 0 0 0"));
  EXPECT_EQ(census(t), (Census{{{q("3/8"), 4}, 2}, {{q("1/2"), 6}, 1}}));
}

TEST(Tessellation, PrismsAroundAScrewAxis) {
  // The orbit of a point of the axis of the tricosm: hexagonal layers at distance 1/3, so prisms over
  // triangles.
  EXPECT_EQ(census(delaunay_tessellation(instance("dimension 3 manifold tricosm points 1 0 0 0"))),
            (Census{{{q("13/36"), 6}, 2}}));
}

TEST(Tessellation, PointsOfOneOrbitAreOnePoint) {
  const Tessellation t = delaunay_tessellation(
      instance("dimension 2 manifold klein-bottle points 3 1/10 1/5 -1/10 7/10 41/10 -9/5"));
  EXPECT_EQ(t.representatives, std::vector<std::size_t>{0});
  EXPECT_EQ(census(t), (Census{{{q("2581/10000"), 3}, 2}}));
}

TEST(Tessellation, ThirdGridIsATriangulationForEveryChoiceOfDiagonals) {
  const Tessellation t = delaunay_tessellation(instance(
      "dimension 2 manifold torus points 9 0 0 0 1/3 0 2/3 1/3 0 1/3 1/3 1/3 2/3 2/3 0 2/3 1/3 2/3 2/3"));
  EXPECT_EQ(census(t), (Census{{{q("1/18"), 4}, 9}}));
  EXPECT_EQ(carries_triangulation(t), Existence::yes);
}

TEST(Tessellation, HalfGridDependsOnNothing) {
  // Four points: the sides of the squares come in pairs with the same ends.
  EXPECT_EQ(carries_triangulation(delaunay_tessellation(
                instance("dimension 2 manifold torus points 4 0 0 0 1/2 1/2 0 1/2 1/2"))),
            Existence::no);
  // The checkerboard {(i/4, j/4): i+j even}: no two sides, but two diagonals may join the same points.
  EXPECT_EQ(
      carries_triangulation(delaunay_tessellation(instance(
          "dimension 2 manifold torus points 8 0 0 0 1/2 1/2 0 1/2 1/2 1/4 1/4 1/4 3/4 3/4 1/4 3/4 3/4"))),
      Existence::depends_on_ties);
}

TEST(Tessellation, ALongLatticeCostsNoMoreThanAShortOne) {
  const Tessellation t =
      delaunay_tessellation(instance("dimension 3 manifold torocosm metric 1e8 0 0 1 0 1e-8 points 1 0 0 0"));
  const Rational squared_radius = (q("100000000") + 1 + q("1/100000000")) / 4;
  EXPECT_EQ(census(t), (Census{{{squared_radius, 8}, 1}}));
}

TEST(Tessellation, RefusesWhatIsNoCrystallographicGroup) {
  EXPECT_THROW(
      static_cast<void>(delaunay_tessellation(instance("dimension 2 generators 1 1 0 1 0 1 0 points 1 0 0"))),
      std::invalid_argument);
}

/// delta^2 and Delta^2 stand in the third and fourth column of the table in corpora/adversarial/README.md.
TEST(Tessellation, LargestEmptyBallsOfTheAdversarialInstances) {
  const std::filesystem::path folder = FLATDT_CORPORA "/adversarial";
  std::istringstream table(text_of(folder / "README.md"));
  std::map<std::string, std::string> expected;
  for (std::string line; std::getline(table, line);) {
    if (!line.starts_with("| `")) continue;
    std::vector<std::string> columns;
    std::istringstream cut(line);
    for (std::string column; std::getline(cut, column, '|');) columns.push_back(column);
    ASSERT_GE(columns.size(), 5U) << line;
    std::istringstream names(columns[1]);
    for (std::string name; std::getline(names, name, ',');)
      expected[name.substr(name.find('`') + 1, name.rfind('`') - name.find('`') - 1)] = columns[4];
  }
  for (const auto& stem : stems(folder, ".instance")) {
    SCOPED_TRACE(stem);
    const std::string value = expected.at(stem.filename());
    const Tessellation t = delaunay_tessellation(read_instance(text_of(with(stem, ".instance"))));
    Rational largest = 0;
    for (const DelaunayCell& cell : t.cells) largest = std::max(largest, cell.squared_radius);
    largest *= 4;
    if (value.find("rounded") == std::string::npos)
      EXPECT_EQ(largest, q(value.substr(1, value.size() - 2).c_str()));
    else
      EXPECT_NEAR(largest.get_d(), std::stod(value), 1e-6);
  }
}

TEST(Polytope, CutsOfACube) {
  Polytope cube = Polytope::parallelotope({}, identity(3), {1, 1, 1}, 3);
  EXPECT_EQ(cube.vertices().size(), 8U);
  Polytope corner = cube;
  corner.cut({{1, 1, 1}, 2});
  EXPECT_EQ(corner.vertices().size(), 10U);  // a corner off
  Polytope through_vertices = cube;
  through_vertices.cut({{1, 1, 1}, 1});
  EXPECT_EQ(through_vertices.vertices().size(), 7U);  // three corners on the border
  Polytope flat = cube;
  flat.cut({{1, 0, 0}, -1});
  EXPECT_EQ(flat.vertices().size(), 4U);
  EXPECT_FALSE(flat.has_interior());
  flat.cut({{0, 1, 1}, 0});  // a square in space, along its diagonal
  EXPECT_EQ(flat.vertices().size(), 3U);
  cube.cut({{1, 0, 0}, -2});
  EXPECT_TRUE(cube.vertices().empty());
}

TEST(Polytope, IntersectionOfSimplices) {
  const Polytope a = Polytope::simplex({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, 2);
  const Polytope side = Polytope::simplex({{2, 0, 0}, {0, 2, 0}, {2, 2, 0}}, 2);
  EXPECT_EQ(intersection(a, side).vertices().size(), 2U);
  EXPECT_FALSE(intersection(a, side).has_interior());
  const Polytope across = Polytope::simplex({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, 2);
  EXPECT_TRUE(intersection(a, across).has_interior());
}

TEST(Hull, VolumesAndEdges) {
  std::vector<Vector> cube;
  cube.reserve(8);
  for (int i = 0; i < 8; ++i) cube.push_back({i & 1, i >> 1 & 1, i >> 2});
  EXPECT_EQ(hull_volume(cube, 3), 1);
  EXPECT_EQ(hull_edges(cube, 3).size(), 12U);
  const std::vector<Vector> octahedron = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                          {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  EXPECT_EQ(hull_volume(octahedron, 3), q("4/3"));
  EXPECT_EQ(hull_edges(octahedron, 3).size(), 12U);
}

/// The orbits of an instance, ready to be asked.
struct GivenOrbits {
  explicit GivenOrbits(const std::string& body)
      : given(instance(body)),
        group(generated_group(given.dimension, given.generators, given.metric)),
        points(group.value(), given.metric, given.points) {}

  [[nodiscard]] Rational squared_distance(const Vector& a, const Vector& b) const {
    return square(given.metric, minus(a, b));
  }

  checker::Instance given;
  std::optional<Group> group;
  OrbitPoints points;
};

const char* const kTwoOrbits = "dimension 2 manifold klein-bottle metric 1/9 0 7 points 2 1/10 1/5 3/4 1/2";

/// Every point of GP within a radius, against counting by brute force over a box of lattice vectors.
TEST(OrbitPoints, WithinABall) {
  const GivenOrbits orbits(kTwoOrbits);
  const std::vector<Vector>& representatives = orbits.given.points;
  const Vector place{q("17/3"), q("-22/7"), 0};
  std::size_t count = 0;
  for (const Seitz& c : orbits.group->cosets)
    for (const Vector& p : representatives)
      for (int i = -40; i <= 40; ++i)
        for (int j = -40; j <= 40; ++j)
          if (orbits.squared_distance(plus(image(c, p), Vector{i, j, 0}), place) <= 10) ++count;
  const std::vector<OrbitPoint> found = orbits.points.within(place, 10);
  EXPECT_EQ(found.size(), count);
  for (const OrbitPoint& p : found) EXPECT_EQ(image(p.element, representatives[p.point]), p.position);
}

/// The nearest points are those within their distance, ties among them; no point is nearer.
TEST(OrbitPoints, NearestToPlaces) {
  const GivenOrbits orbits(kTwoOrbits);
  std::size_t ties = 0;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 10; ++j) {
      const Vector place{Rational(i, 20), Rational(j, 10), 0};
      std::map<Rational, std::size_t> at_distance;
      for (const OrbitPoint& p : orbits.points.within(place, 10)) {
        ++at_distance[orbits.squared_distance(p.position, place)];
      }
      const std::vector<OrbitPoint> nearest = orbits.points.nearest(place);
      ASSERT_FALSE(at_distance.empty());
      const auto& [least, number] = *at_distance.begin();
      EXPECT_EQ(nearest.size(), number);
      for (const OrbitPoint& p : nearest) EXPECT_EQ(orbits.squared_distance(p.position, place), least);
      if (nearest.size() > 1) ++ties;
    }
  }
  EXPECT_GT(ties, 0U);
}

/// Here every vector is as short as multiples of another make it, and yet the sum of three is 10^8 times
/// shorter.
TEST(OrbitPoints, AShortSumOfThreeVectors) {
  const GivenOrbits orbits(
      "dimension 3 generators 2  1 0 0 1 0 1 0 0 0 0 1 0   -1 1 4 2/3 -1 0 2 0 0 0 1 1/3  metric "
      "9007199352092264/3 -4503599676046132/3 -18014398704184528/3 9007199352092264/3 9007199352092264/3 "
      "4722366533909748999091/393216  points 1 0 0 0");
  EXPECT_LT(square(orbits.given.metric, orbits.points.basis().front()), 1);
  EXPECT_EQ(orbits.points.nearest({q("1/3"), q("1/5"), q("1/7")}).size(), 1U);
}

/// Lines of 10^9 translates inside the ball are not gone through one by one.
TEST(OrbitPoints, NearestInALongLattice) {
  const GivenOrbits orbits("dimension 2 manifold torus metric 1/1000000000000000000 0 1 points 1 0 0");
  EXPECT_EQ(orbits.points.nearest({q("1/2"), q("1/2"), 0}).size(), 4U);
}

TEST(Group, OrderOfGeneratorsAndRedundantOnes) {
  // The tetracosm in one screw and one translation, and with generators that say the same again.
  const checker::Instance a = instance(
      "dimension 3 generators 2  1 0 0 1 0 1 0 0 0 0 1 0   0 -1 0 0 1 0 0 0 0 0 1 1/4  points 1 0 0 0");
  const checker::Instance b = instance(
      "dimension 3 generators 4  0 1 0 5 -1 0 0 0 0 0 1 -1/4   -1 0 0 0 0 -1 0 0 0 0 1 1/2 "
      "1 0 0 0 0 1 0 1 0 0 1 3   0 -1 0 0 1 0 0 0 0 0 1 1/4  points 1 0 0 0");
  const std::optional<Group> g = generated_group(3, a.generators, a.metric);
  const std::optional<Group> h = generated_group(3, b.generators, b.metric);
  ASSERT_TRUE(g && h);
  EXPECT_EQ(g->cosets.size(), 4U);
  EXPECT_EQ(g->covolume(), q("1/4"));
  EXPECT_EQ(h->covolume(), q("1/4"));
  for (const Seitz& s : b.generators) EXPECT_TRUE(g->contains(s));
  for (const Seitz& s : a.generators) EXPECT_TRUE(h->contains(s));
  EXPECT_FALSE(g->contains(translation_by({0, 0, q("1/2")}, 3)));
}

}  // namespace
}  // namespace flatdt::oracle
