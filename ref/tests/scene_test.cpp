/// Scenes for viewers: places, copies, orientation, the witness; the texts made of them.
#include "flatdt/ref/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/families.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"

namespace flatdt::ref {
namespace {

double volume(const Scene& scene, const Scene::Cell& cell) {
  std::array<Place3, 3> e{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t x = 0; x < 3; ++x)
      e[k][x] = scene.places[cell.corners[k + 1]][x] - scene.places[cell.corners[0]][x];
  return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
          e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
          e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
         6;
}

Instance instance_of(const char* manifold, long points) {
  return generate(*find_entry(manifold), manifold, "uniform", points, 3, "random");
}

/// The cells with their images fill the lattice cell exactly once: in volume, and with barycentres inside.
TEST(Scene, CellsFillTheLatticeCell) {
  for (const char* manifold : {"torocosm", "dicosm", "second-amphicosm"}) {
    const Instance instance = instance_of(manifold, 2);
    const Triangulation triangulation = triangulate(instance, analyse(instance), {}).triangulation;
    const Scene scene = make_scene(instance, triangulation, {});
    EXPECT_TRUE(scene.notes.empty());
    double sum = 0;
    for (const Scene::Cell& cell : scene.cells) {
      EXPECT_GT(volume(scene, cell), 0);
      sum += volume(scene, cell);
    }
    // The lattice's basis is lower triangular in these coordinates.
    const double expected = scene.lattice[0][0] * scene.lattice[1][1] * scene.lattice[2][2];
    EXPECT_NEAR(sum, expected, 1e-9 * expected) << manifold;
    EXPECT_EQ(scene.full_lattice.has_value(), triangulation.has_subgroup);
    EXPECT_EQ(scene.cells.size() % triangulation.cells.size(), 0U);
    EXPECT_EQ(vtu_text(scene, 1), vtu_text(make_scene(instance, triangulation, {}), 1));
  }
}

/// Products of three edges overflow at 1e300 and vanish at 1e-300; single precision holds 1e-38 to 3e38.
TEST(Scene, ScalesAtTheEndsOfDoubles) {
  const Instance instance = instance_of("dicosm", 2);
  const Triangulation triangulation = triangulate(instance, analyse(instance), {}).triangulation;
  const Scene plain = make_scene(instance, triangulation, {});
  for (const int digits : {300, 80, -30, -300}) {
    const Integer power("1" + std::string(static_cast<std::size_t>(std::abs(digits)), '0'));
    Instance scaled = instance;
    scaled.gram = (digits > 0 ? Rational(power) : Rational(Integer(1), power)) * instance.gram;
    const Scene scene = make_scene(scaled, triangulation, {});
    ASSERT_EQ(scene.cells.size(), plain.cells.size());
    for (std::size_t c = 0; c < scene.cells.size(); ++c)
      EXPECT_EQ(scene.cells[c].corners, plain.cells[c].corners) << digits;
    const std::string page = html_text(scene, 0);
    EXPECT_NE(page.find("Lengths are divided by 2^"), std::string::npos);
    const std::size_t at = page.find("\"lattice\":[[") + 12;
    const double length = std::stod(page.substr(at, 30));
    EXPECT_TRUE(length >= 1 && length < 2) << length;
  }
  EXPECT_EQ(html_text(plain, 0).find("Lengths are divided"), std::string::npos);
}

TEST(Scene, TheWitnessKeepsItsShape) {
  const Instance instance =
      parse_instance("flatdt-instance 1 dimension 3 manifold torocosm points 1 0 0 0\n", "i");
  const Triangulation triangulation = parse_triangulation(
      "flatdt-triangulation 1 elements 1 1 0 0 0 0 1 0 0 0 0 1 0 cells 1 0 0 0 0 0 0 0 0\n", "t", 3, 1);
  const Verdict verdict{"REFUTED",
                        {{"delaunay.empty",
                          {{"cell", "0"},
                           {"facet", "3"},
                           {"cell-points", "(7,0,0);(9,0,0);(7,2,0);(7,0,2)"},
                           {"other-cell", "0"},
                           {"apex", "(8,1,-1/2)"}}}}};
  const Scene scene = make_scene(instance, triangulation, {false, verdict, ""});
  ASSERT_EQ(scene.figures.size(), 3U);
  ASSERT_TRUE(scene.sphere);
  EXPECT_NEAR(scene.sphere->radius, std::sqrt(3.0), 1e-12);
  // Moved by (-7, 0, 0), so that the barycentre is in the cell.
  EXPECT_EQ(scene.figures[0].corners[1], (Place3{2, 0, 0}));
  EXPECT_EQ(scene.is_violated, std::vector<bool>{true});
  const std::string vtu = vtu_text(scene, 0);
  EXPECT_NE(vtu.find("NumberOfCells=\"4\""), std::string::npos);
  // Nothing of the file can leave the script element that holds the data.
  EXPECT_NE(html_text(scene, 0).find("\"kind\":\"other-cell\""), std::string::npos);
  Scene hostile = scene;
  hostile.notes = {"</script><img src=x>\"\\\n"};
  const std::string page = html_text(hostile, 0);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_NE(page.find("\\u003c/script\\u003e\\u003cimg src=x\\u003e\\\"\\\\\\u000a"), std::string::npos);
}

TEST(Scene, NonsenseIsDrawnOrRefused) {
  const Instance instance = instance_of("dicosm", 2);
  for (const char* text : {"flatdt-triangulation 1 elements 0 cells 0\n",
                           "flatdt-triangulation 1 subgroup 0 elements 0 cells 0\n",
                           "flatdt-triangulation 1 subgroup 1 1 0 0 0 0 1 0 0 0 0 1 0 elements 1 1 0 0 0 0 1 "
                           "0 0 0 0 1 0 cells 1 "
                           "0 0 0 0 0 0 0 0\n",
                           "flatdt-triangulation 1 elements 2 1e900 0 1e1000 0 0 1 0 0 0 0 1/7 0  0 0 0 0 0 "
                           "0 0 0 0 0 0 0 cells 2 "
                           "0 0 1 0 0 1 1 1   0 1 1 1 0 1 1 1\n"}) {
    const Scene scene =
        make_scene(instance, parse_triangulation(text, "t", 3, instance.points.size()), {true, {}, ""});
    for (const std::string& made : {vtu_text(scene, 2), html_text(scene, 2)})
      EXPECT_EQ(made.find(" nan"), std::string::npos) << text;
  }
}

TEST(Scene, LimitsAndDimensions) {
  const Instance instance = instance_of("torocosm", 8);
  const Triangulation triangulation = triangulate(instance, analyse(instance), {}).triangulation;
  Scene scene = make_scene(instance, triangulation, {});
  scene.cells.resize(kMaxSceneCells + 1, scene.cells[0]);
  EXPECT_THROW(vtu_text(scene, 0), LimitReached);
  EXPECT_THROW(html_text(scene, 0), LimitReached);
  // A metric whose entries are beyond doubles.
  Instance far = instance;
  far.gram = Rational(Integer("1" + std::string(700, '0'))) * instance.gram;
  EXPECT_THROW(make_scene(far, triangulation, {}), LimitReached);
  const Instance plane = parse_instance("flatdt-instance 1 dimension 2 manifold torus points 1 0 0\n", "i");
  const Triangulation flat = parse_triangulation(
      "flatdt-triangulation 1 elements 3 1 0 0 0 1 0  1 0 1 0 1 0  1 0 0 0 1 1 cells 1 0 0 0 1 0 2\n", "t", 2,
      1);
  const Scene surface = make_scene(plane, flat, {});
  EXPECT_NE(vtu_text(surface, 0).find("<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n5\n"),
            std::string::npos);
  EXPECT_THROW(html_text(surface, 0), InvalidInput);
}

}  // namespace
}  // namespace flatdt::ref
