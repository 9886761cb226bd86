#include "flatdt/ref/triangulation_format.hpp"

#include <gtest/gtest.h>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref {
namespace {

const std::string kTwoCells =
    "flatdt-triangulation 1   # a comment\n"
    "elements 3\n"
    "  1 0 0  0 1 0\n"
    "  1 0 1  0 1 0.0\n"
    "  1 0 0  0 1 1e0\n"
    "cells 2\n"
    "  0 0  0 1  1 2\n"
    "  1 2  0 1\t0 0#end\n";

Triangulation parse(const std::string& text, int dimension = 2, std::size_t points = 2) {
  return parse_triangulation(text, "t.txt", dimension, points);
}

std::string message(const std::string& text, int dimension = 2, std::size_t points = 2) {
  try {
    parse(text, dimension, points);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(TriangulationFormat, ReadsElementsAndCells) {
  const Triangulation t = parse(kTwoCells);
  EXPECT_FALSE(t.has_subgroup);
  ASSERT_EQ(t.elements.size(), 3U);
  EXPECT_EQ(t.elements[1].to_string(), "1 0 1 0 1 0");
  ASSERT_EQ(t.cells.size(), 2U);
  EXPECT_EQ(t.cells[0][2].point, 1U);
  EXPECT_EQ(t.cells[0][2].element, 2U);
  EXPECT_EQ(t.cells[1][1].element, 1U);
}

TEST(TriangulationFormat, ReadsSubgroup) {
  const Triangulation t = parse(replaced(kTwoCells, "elements", "subgroup 1\n 1 0 3 0 1 0\nelements"));
  EXPECT_TRUE(t.has_subgroup);
  ASSERT_EQ(t.subgroup.size(), 1U);
  EXPECT_EQ(t.subgroup[0].translation[0], Rational(3));
}

TEST(TriangulationFormat, EmptySectionsAreGrammatical) {
  const Triangulation t = parse("flatdt-triangulation 1 subgroup 0 elements 0 cells 0\n");
  EXPECT_TRUE(t.has_subgroup);
  EXPECT_TRUE(t.subgroup.empty());
  EXPECT_TRUE(t.elements.empty());
  EXPECT_TRUE(t.cells.empty());
}

TEST(TriangulationFormat, RoundTripKeepsEverything) {
  for (const std::string& section : {std::string(), std::string("subgroup 1 1 0 3/2 0 1 -7\n")}) {
    const Triangulation t = parse(replaced(kTwoCells, "elements", section + "elements"));
    const std::string text = write_triangulation(t, {"first", "second\nthird"});
    EXPECT_NE(text.find("# first\n# second\n# third\n"), std::string::npos);
    const Triangulation again = parse(text);
    EXPECT_EQ(again.has_subgroup, t.has_subgroup);
    EXPECT_EQ(again.subgroup, t.subgroup);
    EXPECT_EQ(again.elements, t.elements);
    EXPECT_EQ(write_triangulation(again, {}), write_triangulation(t, {}));
  }
}

TEST(TriangulationFormat, ThreeDimensionalCellsHaveFourVertices) {
  const std::string text =
      "flatdt-triangulation 1 elements 1 1 0 0 0 0 1 0 0 0 0 1 0 cells 1 0 0 1 0 2 0 3 0\n";
  const Triangulation t = parse(text, 3, 4);
  EXPECT_EQ(t.cells.at(0)[3].point, 3U);
  EXPECT_EQ(write_triangulation(t, {}),
            "flatdt-triangulation 1\nelements 1\n  1 0 0 0 0 1 0 0 0 0 1 0\ncells 1\n  0 0 1 0 2 0 3 0\n");
}

TEST(TriangulationFormat, MessagesHaveFileAndLine) {
  EXPECT_EQ(message(replaced(kTwoCells, "0 0  0 1  1 2", "0 0  0 1  2 2")).substr(0, 8), "t.txt:7:");
  EXPECT_EQ(message(replaced(kTwoCells, "1e0", "1f0")).substr(0, 8), "t.txt:5:");
}

TEST(TriangulationFormat, RefusesWhatTheGrammarRefuses) {
  EXPECT_NE(message(""), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "triangulation 1", "triangulation 2")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "flatdt-triangulation", "flatdt-instance")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "elements 3", "elements 4")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "elements 3", "elements 2")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "cells 2", "cells 1")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "cells 2", "cells -2")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "cells 2", "cells 1000000000000000000000")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "elements 3", "elements 100000001")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "elements 3", "subgroup 10001 elements 3")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "0 0  0 1  1 2", "0 0  0 1  1 3")), "accepted");
  EXPECT_NE(message(replaced(kTwoCells, "#end\n", "")), "accepted");       // ends directly after a token
  EXPECT_NE(message(replaced(kTwoCells, "#end\n", "\n0\n")), "accepted");  // something after the last cell
  EXPECT_NE(message("flatdt-triangulation 1 elements 0 cells 1 0 0 0 0 0 0\n"), "accepted");
  EXPECT_NE(message("flatdt-triangulation 1 cells 0\n"), "accepted");
  EXPECT_NE(message("flatdt-triangulation 1 elements 0 subgroup 0 cells 0\n"), "accepted");
}

TEST(TriangulationFormat, EveryPrefixIsRefused) {
  for (std::size_t n = 0; n + 5 < kTwoCells.size(); ++n)
    EXPECT_NE(message(kTwoCells.substr(0, n)), "accepted") << n;
}

}  // namespace
}  // namespace flatdt::ref
