/// Pictures: well-formed, deterministic, with the elements they promise, and no crash on nonsense that
/// parses.
#include "flatdt/ref/svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/families.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::ref {
namespace {

/// Tags are closed in order, attributes are quoted, no stray '<', '&' only as an entity.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < xml.size(); ++i) {
    if (xml[i] == '&' && xml.compare(i, 4, "&lt;") != 0 && xml.compare(i, 4, "&gt;") != 0 &&
        xml.compare(i, 5, "&amp;") != 0)
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
  const std::size_t cells = drawing.svg.find("<g class=\"cells\">");
  EXPECT_EQ(occurrences(drawing.svg.substr(cells, drawing.svg.find("</g>", cells) - cells), "<path"), 2U);
}

TEST(Svg, MarksALoop) {
  const Drawing drawing = draw(torus("1 1/2 1/2"), kOnePoint, true);
  EXPECT_TRUE(well_formed(drawing.svg));
  EXPECT_EQ(occurrences(drawing.svg, "<path class=\"cycle\""), 1U);
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
  EXPECT_EQ(occurrences(drawing.svg, "<path class=\"cycle\""), 1U);
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

TEST(Svg, ACoverHasBothCells) {
  std::string text = kOnePoint;
  text.insert(text.find("elements"), "subgroup 2 1 0 3 0 1 0  1 0 0 0 1 3\n");
  const Drawing drawing = draw(torus("1 1/2 1/2"), text);
  EXPECT_TRUE(well_formed(drawing.svg));
  EXPECT_NE(drawing.svg.find("covering space"), std::string::npos);
  EXPECT_EQ(occurrences(drawing.svg, "<path class=\"lattice\""), 1U);
  EXPECT_EQ(occurrences(drawing.svg, "<path class=\"domain\""), 1U);
}

TEST(Svg, NonsenseIsDrawnOrRefused) {
  const Instance instance = torus("2 0 0 1/2 1/3");
  const std::vector<std::string> texts = {
      "flatdt-triangulation 1 elements 0 cells 0\n", "flatdt-triangulation 1 subgroup 0 elements 0 cells 0\n",
      "flatdt-triangulation 1 subgroup 1 1 0 0 0 1 0 elements 1 1 0 0 0 1 0 cells 1 0 0 0 0 0 0\n",
      "flatdt-triangulation 1 subgroup 2 -1 0 0 0 -1 0 1 1 0 0 1 0 elements 1 1 0 0 0 1 0 cells 1 0 0 1 0 1 "
      "0\n",
      // Elements outside the group, singular, huge and tiny.
      "flatdt-triangulation 1 elements 4 0 0 0 0 0 0  1e900 0 1e1000 0 1 0  1/7 0 1e-1000 5 2 1  1 0 0 0 1 "
      "0\n"
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
