/// Tests with GoogleTest: a triangulation is right, or the failure message holds the witness.
#include <gmock/gmock.h>

#include "flatdt/testing/gtest_matchers.hpp"
#include "my_triangulation.hpp"

using flatdt::testing::is_delaunay_triangulation;
using flatdt::testing::IsDelaunayTriangulationOf;
using flatdt::testing::ViolatesCondition;
using testing::Not;

const char* const kThreePoints =
    "flatdt-instance 1 dimension 2 manifold klein-bottle points 3\n"
    "  1/10 1/5   0.75 0.375   0.4 0.9\n";

TEST(MyTriangulation, IsDelaunayOnTheKleinBottle) {
  EXPECT_THAT(my_triangulation(kThreePoints), IsDelaunayTriangulationOf(kThreePoints));
}

TEST(MyTriangulation, IsDelaunayInSpace) {  // without GoogleMock
  const std::string instance =
      "flatdt-instance 1 dimension 3 manifold didicosm points 2\n"
      "  0.1 0.2 0.3   0.45 0.85 0.6\n";
  EXPECT_TRUE(is_delaunay_triangulation(my_triangulation(instance), instance));
}

/// A test for a bug that is known: two triangles that cover the square torus, but are not Delaunay.
TEST(TheFlipBug, IsRefutedForTheRightReason) {
  const std::string torus = "flatdt-instance 1 dimension 2 manifold torus points 1 0 0\n";
  const std::string flipped =
      "flatdt-triangulation 1\n"
      "elements 4   1 0 0 0 1 0   1 0 1 0 1 0   1 0 2 0 1 1   1 0 1 0 1 1\n"
      "cells 2      0 0 0 1 0 2   0 0 0 2 0 3\n";
  EXPECT_THAT(flipped, Not(IsDelaunayTriangulationOf(torus)));
  EXPECT_THAT(flipped, ViolatesCondition("delaunay.empty", torus));
}
