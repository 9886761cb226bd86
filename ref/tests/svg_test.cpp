/// Pictures: well-formed, deterministic, with the elements they promise, and no crash on nonsense that
/// parses.
#include "flatdt/ref/svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/families.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/refutation.hpp"
#include "flatdt/ref/triangulate.hpp"

namespace flatdt::ref {
namespace {

/// Tags are closed in order, attributes are quoted, no stray '<', '&' only as an entity.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < xml.size(); ++i) {
    if (xml[i] == '&' && xml.compare(i, 4, "&lt;") != 0 && xml.compare(i, 4, "&gt;") != 0 &&
        xml.compare(i, 5, "&amp;") != 0 && xml.compare(i, 6, "&quot;") != 0)
      return false;
    if (xml[i] == '>') return false;
    if (xml[i] != '<') continue;
    const std::size_t end = xml.find('>', i);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(i + 1, end - i - 1);
    i = end;
    if (tag.find('<') != std::string::npos || std::count(tag.begin(), tag.end(), '"') % 2 != 0) return false;
    if (tag[0] == '?') continue;
    const std::string name =
        tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag[0] == '/' ? 1 : 0));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
  }
  return open.empty();
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

/// What stands between <g class="NAME"> and the next </g>.
std::string group(const std::string& svg, const std::string& name) {
  const std::size_t begin = svg.find("<g class=\"" + name + "\">");
  return begin == std::string::npos ? "" : svg.substr(begin, svg.find("</g>", begin) - begin);
}

Instance torus(const std::string& points) {
  return parse_instance("flatdt-instance 1 dimension 2 manifold torus points " + points + "\n", "instance");
}

/// The square torus with one point: two triangles, three loops.
const std::string kOnePoint =
    "flatdt-triangulation 1 elements 4 1 0 0 0 1 0  1 0 1 0 1 0  1 0 0 0 1 1  1 0 1 0 1 1\n"
    "cells 2  0 0 0 1 0 3  0 0 0 2 0 3\n";

Drawing draw(const Instance& instance, const std::string& text, bool cycle = false, bool violation = false) {
  return draw_svg(instance, parse_triangulation(text, "t", 2, instance.points.size()), {cycle, violation});
}

TEST(Svg, HasEverythingItPromises) {
  const Instance instance = torus("1 1/2 1/2");
  const Drawing drawing = draw(instance, kOnePoint);
  EXPECT_TRUE(well_formed(drawing.svg)) << drawing.svg;
  for (const char* part :
       {"<title", "<desc", "class=\"domain\"", "class=\"point\"", ">0</text>", "prefers-color-scheme"})
    EXPECT_NE(drawing.svg.find(part), std::string::npos) << part;
  EXPECT_TRUE(drawing.notes.empty());
  EXPECT_EQ(drawing.svg, draw(instance, kOnePoint).svg);
  // The barycentres of both triangles are in the fundamental cell once.
  EXPECT_EQ(occurrences(group(drawing.svg, "cells"), "<path"), 2U);
}

TEST(Svg, MarksALoop) {
  const Drawing drawing = draw(torus("1 1/2 1/2"), kOnePoint, true);
  EXPECT_TRUE(well_formed(drawing.svg));
  EXPECT_EQ(occurrences(group(drawing.svg, "witness"), "<path class=\"mark-face\""), 1U);
  ASSERT_EQ(drawing.notes.size(), 1U);
  EXPECT_EQ(drawing.notes[0].substr(0, 4), "Loop");
}

TEST(Svg, MarksATwoCycle) {
  // Two points on a row: the edges from 0 to 1 on both sides have the same ends.
  const std::string text =
      "flatdt-triangulation 1 elements 2 1 0 0 0 1 0  1 0 -1 0 1 0\n"
      "cells 2  0 0 1 0 2 0   0 0 1 1 2 0\n";
  const Drawing drawing = draw(torus("3 0 0 1/2 0 1/4 1/2"), text, true);
  ASSERT_EQ(drawing.notes.size(), 1U);
  EXPECT_EQ(drawing.notes[0].substr(0, 7), "2-cycle");
  // Of the two edges one is dashed.
  EXPECT_EQ(occurrences(group(drawing.svg, "witness"), "<path class=\"mark-face\""), 1U);
  EXPECT_EQ(occurrences(group(drawing.svg, "witness"), "<path class=\"mark-other-face\""), 1U);
}

TEST(Svg, MarksAViolatedDisk) {
  const std::string text = "flatdt-triangulation 1 elements 1 1 0 0 0 1 0 cells 1  0 0 1 0 2 0\n";
  const Drawing drawing = draw(torus("4 0 0 1/2 0 0 1/2 1/4 1/5"), text, false, true);
  EXPECT_TRUE(well_formed(drawing.svg));
  EXPECT_EQ(occurrences(drawing.svg, "class=\"disk\""), 1U);
  ASSERT_EQ(drawing.notes.size(), 1U);
  EXPECT_NE(drawing.notes[0].find("has point 3 inside"), std::string::npos) << drawing.notes[0];
  // On the circle is not inside.
  const Drawing none = draw(torus("4 0 0 1/2 0 0 1/2 1/2 1/2"), text, false, true);
  EXPECT_EQ(occurrences(none.svg, "class=\"disk\""), 0U);
  EXPECT_EQ(none.notes.at(0), "No circumdisk has a point strictly inside.");
}

/// The first cell whose disk has an image inside, found by looking at all images near the cell's lattice
/// cell.
std::string first_violated(const Instance& instance, const Triangulation& triangulation) {
  const GroupAnalysis analysis = analyse(instance);
  const Matrix to_lattice = analysis.frame.basis.inverse();
  for (std::size_t k = 0; k < triangulation.cells.size(); ++k) {
    std::vector<Vector> corners;
    for (std::size_t c = 0; c < 3; ++c)
      corners.push_back(triangulation.elements[triangulation.cells[k][c].element] *
                        instance.points[triangulation.cells[k][c].point]);
    const auto disk = circumscribed_ball(instance.gram, corners);
    if (!disk) continue;
    const Vector at = to_lattice * disk->centre;
    for (const Vector& point : instance.points)
      for (const Isometry& g : analysis.cosets) {
        const Vector u = to_lattice * (g * point);
        for (int i = -1; i <= 2; ++i)
          for (int j = -1; j <= 2; ++j) {
            Vector near = u;
            near[0] += Rational(floor(at[0] - u[0])) + Rational(i);
            near[1] += Rational(floor(at[1] - u[1])) + Rational(j);
            if (squared_length(instance.gram, analysis.frame.basis * near - disk->centre) <
                disk->radius_squared)
              return "Violation: the circumdisk of cell " + std::to_string(k) + " ";
          }
      }
  }
  return "No circumdisk has a point strictly inside.";
}

TEST(Svg, FindsTheFirstViolatedDisk) {
  std::size_t found = 0, tries = 0;
  for (const char* name : {"torus", "klein-bottle"})
    for (const char* family : {"uniform", "clustered", "grid"})
      for (unsigned seed = 1; seed <= 2; ++seed) {
        Instance instance = generate(*find_entry(name), name, family, 9, seed, "random");
        const auto result = triangulate(instance, analyse(instance), {});
        // A point that has moved, by more each time: from disks of its neighbours to wide ones.
        for (int k = 8; k >= 0; k -= 2) {
          const std::string expected = first_violated(instance, result.triangulation);
          const Drawing drawing = draw_svg(instance, result.triangulation, {false, true});
          EXPECT_EQ(drawing.notes.at(0).rfind(expected, 0), 0U) << drawing.notes[0] << expected;
          ++tries;
          if (expected[0] == 'V') ++found;
          instance.points[seed][0] += Rational::ratio(1, std::int64_t{1} << static_cast<unsigned>(k));
        }
      }
  EXPECT_GT(found, tries / 3);
  EXPECT_LT(found, tries);
}

/// Every cell against every point would be 24 million distances, a minute or more.
TEST(Svg, LooksForAViolationNearEachDisk) {
  const Instance instance = generate(*find_entry("torus"), "torus", "uniform", 1'500, 1, "canonical");
  const auto result = triangulate(instance, analyse(instance), {});
  const Drawing drawing = draw_svg(instance, result.triangulation, {false, true});
  EXPECT_EQ(drawing.notes.at(0), "No circumdisk has a point strictly inside.");
}

TEST(Svg, RefusesToLookForever) {
  Instance instance = generate(*find_entry("torus"), "torus", "uniform", 1'200, 1, "canonical");
  // Disks as wide as the lattice's cell, on whose circles all lie: every point is looked at for each of them.
  for (Vector& point : instance.points) point = instance.points[0];
  Triangulation triangulation = parse_triangulation(
      "flatdt-triangulation 1 elements 3 1 0 0 0 1 0  1 0 1 0 1 0  1 0 0 0 1 1 cells 1 0 0 0 1 0 2\n", "t", 2,
      1200);
  triangulation.cells.resize(3'000, triangulation.cells[0]);
  EXPECT_THROW(draw_svg(instance, triangulation, {false, true}), LimitReached);
}

TEST(Svg, ACoverHasBothCells) {
  std::string text = kOnePoint;
  text.insert(text.find("elements"), "subgroup 2 1 0 3 0 1 0  1 0 0 0 1 3\n");
  const Drawing drawing = draw(torus("1 1/2 1/2"), text);
  EXPECT_TRUE(well_formed(drawing.svg));
  EXPECT_NE(drawing.svg.find("covering space"), std::string::npos);
  EXPECT_EQ(occurrences(drawing.svg, "<path class=\"lattice\""), 1U);
  EXPECT_EQ(occurrences(drawing.svg, "<path class=\"domain\""), 1U);
}

TEST(Svg, AKleinBottleIsHalfALatticeCell) {
  const Instance instance =
      parse_instance("flatdt-instance 1 dimension 2 manifold klein-bottle points 1 1/8 0\n", "instance");
  // Two triangles of area 1/4 fill the domain of area 1/2; the mirror line of the glide is x = 0.
  const std::string text =
      "flatdt-triangulation 1 elements 4 1 0 0 0 1 0  1 0 1 0 1 0  -1 0 1 0 1 1/2  -1 0 0 0 1 1/2\n"
      "cells 2  0 0 0 1 0 2   0 0 0 2 0 3\n";
  const Drawing drawing = draw(instance, text);
  EXPECT_EQ(occurrences(group(drawing.svg, "cells"), "<path"), 2U);
  EXPECT_GT(occurrences(group(drawing.svg, "copies"), "turned"), 0U);
  // Of 900 page units the domain with margins of 1/4 takes 3/2: it is 600 wide, half as high, and its corner
  // is a quarter of 600 from the edge.
  EXPECT_NE(drawing.svg.find("<path class=\"domain\" d=\"M150 450L750 450L750 150L150 150Z\"/>"),
            std::string::npos);
  // One arrow head on each upper and lower side, pointing opposite ways; two on the others.
  EXPECT_EQ(occurrences(drawing.svg, "<path class=\"arrow\""), 6U);
  EXPECT_NE(drawing.svg.find("class=\"arrow\" d=\"M456.50 450L"), std::string::npos);
  EXPECT_NE(drawing.svg.find("class=\"arrow\" d=\"M443.50 150L"), std::string::npos);
  EXPECT_EQ(drawing.svg, draw(instance, text).svg);
}

TEST(Svg, ShowsTheWitnessOfAVerdict) {
  const Instance instance = torus("4 0 0 1/2 0 0 1/2 1/4 1/5");
  const Triangulation triangulation =
      parse_triangulation("flatdt-triangulation 1 elements 1 1 0 0 0 1 0 cells 1  0 0 1 0 2 0\n", "t", 2, 4);
  DrawingOptions options;
  options.verdict = Verdict{"REFUTED",
                            {{"volume.exact", {{"volume-of-cells", "1/8"}, {"expected", "1"}}},
                             {"delaunay.empty",
                              {{"cell", "0"},
                               {"facet", "1"},
                               {"cell-points", "(0,0);(1/2,0);(0,1/2)"},
                               {"other-cell", "0"},
                               {"apex", "(1/4,1/5)"}}}}};
  const Drawing drawing = draw_svg(instance, triangulation, options);
  EXPECT_TRUE(well_formed(drawing.svg));
  const std::string witness = group(drawing.svg, "witness");
  EXPECT_EQ(occurrences(witness, "class=\"disk\""), 1U);
  EXPECT_EQ(occurrences(witness, "class=\"mark-cell\""), 1U);
  EXPECT_EQ(occurrences(witness, "class=\"mark-other-cell\""), 1U);
  EXPECT_NE(drawing.svg.find("REFUTED: the circumscribed disk of cell 0"), std::string::npos);
  EXPECT_NE(drawing.svg.find("These fail too: volume.exact."), std::string::npos);
  options.condition = "volume.exact";
  EXPECT_NE(draw_svg(instance, triangulation, options).svg.find("sum to 1/8 instead of 1"),
            std::string::npos);
  options.condition = "links.spheres";
  EXPECT_THROW(draw_svg(instance, triangulation, options), InvalidInput);
  options.condition.clear();
  options.show_copies = false;
  EXPECT_EQ(occurrences(group(draw_svg(instance, triangulation, options).svg, "copies"), "<path"), 0U);
}

TEST(Svg, NonsenseIsDrawnOrRefused) {
  const Instance instance = torus("2 0 0 1/2 1/3");
  const std::vector<std::string> texts = {
      "flatdt-triangulation 1 elements 0 cells 0\n", "flatdt-triangulation 1 subgroup 0 elements 0 cells 0\n",
      "flatdt-triangulation 1 subgroup 1 1 0 0 0 1 0 elements 1 1 0 0 0 1 0 cells 1 0 0 0 0 0 0\n",
      std::string("flatdt-triangulation 1 subgroup 2 -1 0 0 0 -1 0 1 1 0 0 1 0 ") +
          "elements 1 1 0 0 0 1 0 cells 1 0 0 1 0 1 0\n",
      // Elements outside the group, singular, huge and tiny.
      std::string("flatdt-triangulation 1 elements 4 0 0 0 0 0 0  1e900 0 1e1000 0 1 0  ") +
          "1/7 0 1e-1000 5 2 1  1 0 0 0 1 0\n" +
          "cells 4 0 0 1 0 0 1  0 1 1 2 1 0  1 1 1 2 0 3  0 3 1 3 0 2\n"};
  for (const std::string& text : texts) {
    const Drawing drawing = draw(instance, text, true, true);
    EXPECT_TRUE(well_formed(drawing.svg)) << text;
    EXPECT_EQ(drawing.svg.find("nan"), std::string::npos);
    EXPECT_EQ(drawing.svg.find("inf"), std::string::npos);
  }
}

TEST(Svg, EveryFamilyCanBeDrawn) {
  for (const char* name : {"torus", "klein-bottle"})
    for (const Family& family : families()) {
      const Instance instance = generate(*find_entry(name), name, family.name, 6, 1, "random");
      EXPECT_TRUE(well_formed(draw(instance, "flatdt-triangulation 1 elements 0 cells 0\n", true, true).svg))
          << family.name;
    }
}

TEST(Svg, RefusesDimensionThree) {
  const Instance instance = generate(*find_entry("dicosm"), "dicosm", "uniform", 1, 1);
  Triangulation triangulation;
  triangulation.dimension = 3;
  EXPECT_THROW(draw_svg(instance, triangulation, {}), InvalidInput);
}

}  // namespace
}  // namespace flatdt::ref
