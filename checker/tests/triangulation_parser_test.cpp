// Triangulation files.   Source: FORMAT.md, "Triangulation".
#include <gtest/gtest.h>

#include <string>

#include "build.hpp"

namespace flatdt::checker::test {
namespace {

const std::string kInstance = "flatdt-instance 1 dimension 2 manifold torus points 2 0 0 1/2 1/2 ";
const std::string kHead = "flatdt-triangulation 1 ";
const std::string kElement = "1 0 0 0 1 0 ";

Triangulation read(const std::string& text) {
  return read_triangulation(text, read_instance(kInstance));
}

void expect_malformed(const std::string& text, const std::string& part_of_reason) {
  try {
    (void)read(text);
    ADD_FAILURE() << "accepted: " << text;
  } catch (const MalformedInput& error) {
    EXPECT_NE(std::string(error.what()).find(part_of_reason), std::string::npos) << error.what();
  }
}

TEST(TriangulationParser, ReadsAllSections) {
  const Triangulation t = read(kHead + "subgroup 1 1 0 3 0 1 0\nelements 2 " + kElement +
                               "1 0 0.5 0 1 -1/3\ncells 1\n0 0 1 1 0 1\n");
  ASSERT_TRUE(t.subgroup.has_value());
  EXPECT_EQ(t.subgroup->at(0).translation[0], 3);
  ASSERT_EQ(t.elements.size(), 2U);
  EXPECT_EQ(t.element(1).translation[0], Rational(1, 2));
  EXPECT_EQ(t.element(1).translation[1], Rational(-1, 3));
  EXPECT_EQ(t.element(1).linear[1][1], 1);
  ASSERT_EQ(t.cells.size(), 1U);
  EXPECT_EQ(t.cells[0][1].point, 1U);
  EXPECT_EQ(t.cells[0][2].element, 1U);
}

TEST(TriangulationParser, EmptySectionsAreGrammatical) {
  const Triangulation t = read(kHead + "subgroup 0 elements 0 cells 0\n");
  ASSERT_TRUE(t.subgroup.has_value());
  EXPECT_TRUE(t.subgroup->empty());
  EXPECT_FALSE(read(kHead + "elements 0 cells 0\n").subgroup.has_value());
}

TEST(TriangulationParser, SectionsInOrderAndAtMostOnce) {
  expect_malformed("", "expected 'flatdt-triangulation'");
  expect_malformed("flatdt-triangulation 2 ", "expected '1'");
  expect_malformed(kHead + "cells 0 ", "expected 'elements'");
  expect_malformed(kHead + "elements 0 subgroup 0 cells 0 ", "expected 'cells'");
  expect_malformed(kHead + "subgroup 0 subgroup 0 elements 0 cells 0 ", "expected 'elements'");
  expect_malformed(kHead + "elements 0 cells 0 cells 0 ", "expected the end of the file");
  expect_malformed(kHead + "elements 0 cells 0", "ends directly after");
  expect_malformed(kHead + "elements 1 1 0 0 0 1 cells 0 ", "an entry of an element");
  expect_malformed(kHead + "elements 0 ", "expected 'cells'");
}

TEST(TriangulationParser, Indices) {
  const std::string start = kHead + "elements 1 " + kElement + "cells 1 ";
  EXPECT_EQ(read(start + "1 0 00 0 0 000 ").cells.size(), 1U);
  expect_malformed(start + "2 0 0 0 0 0 ", "a point index must be from 0 to 1");
  expect_malformed(start + "0 1 0 0 0 0 ", "an element index must be from 0 to 0");
  expect_malformed(start + "-1 0 0 0 0 0 ", "a point index");
  expect_malformed(start + "0.0 0 0 0 0 0 ", "a point index");
  expect_malformed(start + "18446744073709551616 0 0 0 0 0 ", "a point index");
  expect_malformed(start + "0 0 0 0 0 ", "an element index");
  expect_malformed(start + "0 0 0 0 0 0 0 ", "expected the end of the file");
  expect_malformed(kHead + "elements 0 cells 1 0 0 0 0 0 0 ",
                   "an element index out of range: there are none");
}

TEST(TriangulationParser, CountLimits) {
  expect_malformed(kHead + "elements 100000001 ", "number of elements");
  expect_malformed(kHead + "elements 100000000 ", "found the end of the file");
  expect_malformed(kHead + "elements 0 cells 1000000001 ", "number of cells");
  expect_malformed(kHead + "elements 1 " + kElement + "cells 1000000000 ", "found the end of the file");
  expect_malformed(kHead + "elements 0 cells 1000000000000000000 ", "number of cells");
  expect_malformed(kHead + "subgroup 10001 ", "number of generators");
}

}  // namespace
}  // namespace flatdt::checker::test
