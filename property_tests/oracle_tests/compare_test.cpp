/// The comparison accepts what is equal up to ties, and reports every kind of alteration.
#include "oracle/compare.hpp"

#include <gtest/gtest.h>

#include "fixture.hpp"

namespace flatdt::oracle {
namespace {

using oracle_tests::Answer;
using oracle_tests::answer_of_ref;
using oracle_tests::read_instance;
using oracle_tests::read_triangulation;

const char* const kNinePoints =
    "flatdt-instance 1 dimension 2 manifold torus points 9 1/100 0 1/50 1/3 0 13/20 1/3 1/40 17/50 1/3 "
    "31/100 2/3 "
    "2/3 -1/30 33/50 1/3 2/3 7/10\n";
const char* const kSquare = "flatdt-instance 1 dimension 2 manifold torus points 1 0 0\n";
const char* const kSquareElements =
    "flatdt-triangulation 1 elements 4 1 0 0 0 1 0  1 0 1 0 1 0  1 0 0 0 1 1  1 0 1 0 1 1 cells ";

std::string compared(const checker::Instance& instance, const checker::Triangulation& triangulation) {
  return difference(instance, delaunay_tessellation(instance), triangulation);
}

std::string square_with(const std::string& cells) {
  const checker::Instance instance = read_instance(kSquare);
  return compared(instance, read_triangulation(kSquareElements + cells + "\n", instance));
}

TEST(Compare, EitherDiagonalOfASquareIsRight) {
  EXPECT_EQ(square_with("2  0 0 0 1 0 3  0 0 0 3 0 2"), "");
  EXPECT_EQ(square_with("2  0 0 0 1 0 2  0 1 0 3 0 2"), "");
}

TEST(Compare, TwoHalvesOfASquareThatOverlap) {
  EXPECT_NE(square_with("2  0 0 0 1 0 3  0 0 0 1 0 2").find("overlap"), std::string::npos);
  EXPECT_NE(square_with("2  0 0 0 1 0 3  0 0 0 1 0 3").find("overlap"), std::string::npos);
}

TEST(Compare, MissingAndFlatCells) {
  EXPECT_NE(square_with("1  0 0 0 1 0 3").find("volume 1/2 instead of 1"), std::string::npos);
  EXPECT_NE(square_with("0").find("0 of 1 sheets"), std::string::npos);
  EXPECT_NE(square_with("1  0 0 0 1 0 1").find("flat"), std::string::npos);
}

class Altered : public testing::Test {
 protected:
  Altered() : answer_(answer_of_ref(kNinePoints)) {
    EXPECT_EQ(answer_.result.sheets, 1);
    EXPECT_EQ(compared(answer_.instance, answer_.triangulation), "");
  }
  [[nodiscard]] std::string now() const { return compared(answer_.instance, answer_.triangulation); }
  Answer answer_;
};

TEST_F(Altered, CellRemoved) {
  answer_.triangulation.cells.pop_back();
  EXPECT_NE(now().find("0 of 1 sheets"), std::string::npos);
}

TEST_F(Altered, CellDoubled) {
  answer_.triangulation.cells.push_back(answer_.triangulation.cells.front());
  EXPECT_NE(now().find("instead of"), std::string::npos);
}

TEST_F(Altered, EveryChangeOfOneVertexOfEveryCell) {
  const Tessellation tessellation = delaunay_tessellation(answer_.instance);
  for (std::size_t k = 0; k < answer_.triangulation.cells.size(); ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      const checker::FileVertex before = answer_.triangulation.cells[k][j];
      for (std::uint32_t i = 0; i < 9; ++i) {
        if (i == before.point) continue;
        answer_.triangulation.cells[k][j].point = i;
        EXPECT_NE(difference(answer_.instance, tessellation, answer_.triangulation), "")
            << "cell " << k << " corner " << j << " point " << i;
      }
      answer_.triangulation.cells[k][j] = before;
    }
  }
}

TEST_F(Altered, PointMovedByLittle) {
  const Tessellation before = delaunay_tessellation(answer_.instance);
  answer_.instance.points[4][0] += Rational(1, 1UL << 40U);
  EXPECT_NE(difference(answer_.instance, before, answer_.triangulation), "");
  EXPECT_EQ(now(), "");  // so little that the cells are the same
}

TEST_F(Altered, OtherMetric) {
  answer_.instance.metric[0][0] = 4;
  EXPECT_NE(now(), "");
}

TEST_F(Altered, CoverClaimedForTheManifold) {
  Answer cover = answer_of_ref(kSquare);
  ASSERT_EQ(cover.result.sheets, 9);
  EXPECT_EQ(compared(cover.instance, cover.triangulation), "");
  cover.triangulation.subgroup.reset();
  EXPECT_NE(compared(cover.instance, cover.triangulation), "");
}

TEST_F(Altered, ManifoldClaimedForACover) {
  answer_.triangulation.subgroup = {{identity(2), {2, 0, 0}}, {identity(2), {0, 1, 0}}};
  EXPECT_NE(now().find("1 of 2 sheets"), std::string::npos);
  answer_.triangulation.subgroup = {{identity(2), {Rational(1, 2), 0, 0}}, {identity(2), {0, 1, 0}}};
  EXPECT_NE(now().find("not in the group"), std::string::npos);
  answer_.triangulation.subgroup = std::vector<Seitz>{{identity(2), {2, 0, 0}}};
  EXPECT_NE(now().find("infinite index"), std::string::npos);
}

}  // namespace
}  // namespace flatdt::oracle
