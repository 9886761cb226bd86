/// Witnesses of verdicts: every figure that a key can give, and nothing that is not there.
#include "flatdt/ref/refutation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::ref {
namespace {

const char* const kInstance = "flatdt-instance 1 dimension 2 manifold torus points 3  0 0  1/2 0  0 1/2\n";
const char* const kTriangulation =
    "flatdt-triangulation 1 elements 2  1 0 0 0 1 0  1 0 1/3 0 1 0\n"
    "cells 3  0 0 1 0 2 0   0 0 1 0 2 0   0 0 1 1 2 0\n";

class RefutationTest : public testing::Test {
 protected:
  [[nodiscard]] Witness read(const std::string& condition,
                             std::vector<std::pair<std::string, std::string>> values) const {
    return witness_of({condition, std::move(values)}, instance, triangulation);
  }
  /// The kinds of the marks and their corners, as text.
  static std::string marks(const Witness& witness) {
    std::string text;
    for (const Mark& mark : witness.marks) {
      text += std::to_string(static_cast<int>(mark.kind)) + ":";
      for (const Vector& x : mark.corners) text += "(" + x.to_string() + ")";
      text += " ";
    }
    return text;
  }
  Instance instance = parse_instance(kInstance, "i");
  Triangulation triangulation = parse_triangulation(kTriangulation, "t", 2, 3);
};

TEST_F(RefutationTest, AViolatedDiskHasItsCellsBallAndApex) {
  const Witness w = read("delaunay.empty", {{"cell", "0"},
                                            {"facet", "2"},
                                            {"cell-points", "(0,0);(1/2,0);(0,1/2)"},
                                            {"other-cell", "1"},
                                            {"apex", "(1/4,-1/9)"}});
  EXPECT_EQ(marks(w), "0:(0 0)(1/2 0)(0 1/2) 1:(0 0)(1/2 0)(1/4 -1/9) 4:(1/4 -1/9) ");
  ASSERT_TRUE(w.ball);
  EXPECT_EQ(w.ball->centre.to_string(), "1/4 1/4");
  EXPECT_EQ(w.ball->radius_squared.to_string(), "1/8");
  EXPECT_EQ(w.cells, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(w.notes.empty());
  EXPECT_EQ(w.sentence, "the circumscribed disk of cell 0 has a vertex of cell 1 inside");
}

TEST_F(RefutationTest, EdgesAreLiftsOfPoints) {
  const Witness w = read("skeleton.no-2-cycle", {{"edge", "[1,0|0;0,1|0]*0;[1,0|0;0,1|0]*1"},
                                                 {"other-edge", "[1,0|0;0,1|0]*0;[-1,0|-1/2;0,1|1]*1"}});
  EXPECT_EQ(marks(w), "2:(0 0)(1/2 0) 3:(0 0)(-1 1) ");
}

TEST_F(RefutationTest, AFacetIsThatOfItsCell) {
  const Witness w = read("facets.paired", {{"cell", "0"},
                                           {"facet", "0"},
                                           {"cell-points", "(0,0);(1/2,0);(0,1/2)"},
                                           {"facet-vertices", "[1,0|5;0,1|5]*1;[1,0|5;0,1|5]*2"},
                                           {"occurrences", "3"}});
  EXPECT_EQ(marks(w), "0:(0 0)(1/2 0)(0 1/2) 2:(1/2 0)(0 1/2) ");
  EXPECT_EQ(w.sentence, "a facet of cell 0 occurs 3 times instead of twice");
  EXPECT_EQ(read("facets.paired", {{"cell", "0"}, {"occurrences", "1"}}).sentence,
            "a facet of cell 0 occurs once instead of twice");
}

TEST_F(RefutationTest, CornersVerticesCellsPointsAndElements) {
  EXPECT_EQ(marks(read("simplices.injective", {{"cell-points", "(0,0);(1,0);(1,1)"}, {"corners", "0,2"}})),
            "0:(0 0)(1 0)(1 1) 2:(0 0)(1 1) ");
  EXPECT_EQ(marks(read("links.spheres", {{"vertex", "[1,0|1;0,1|0]*2"}})), "4:(1 1/2) ");
  EXPECT_EQ(read("topology.connected", {{"cells", "0,2"}}).cells, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(read("vertices.complete", {{"point", "2"}}).point, 2U);
  // The first cell that uses element 1.
  EXPECT_EQ(read("subgroup.member", {{"number", "1"}}).cells, (std::vector<std::uint32_t>{2}));
}

TEST_F(RefutationTest, NonsenseBecomesNotes) {
  const std::vector<std::pair<std::string, std::string>> values = {{"cell-points", "(0,0);(1,0)"},
                                                                   {"cell-points", "(0,0);(1/0,0);(1,1)"},
                                                                   {"cell-points", "(0,0);(1,0);(1,1"},
                                                                   {"cell", "3"},
                                                                   {"cell", "-1"},
                                                                   {"cell", ""},
                                                                   {"cells", "0,"},
                                                                   {"point", "4294967296"},
                                                                   {"edge", "[1,0|0;0,1|0]*3"},
                                                                   {"edge", "[1,0,0|0;0,1|0]*0"},
                                                                   {"vertex", "[1,0|0;0,1|0]*0 "},
                                                                   {"face", "[1,0|0;0,1|0]*"}};
  for (const auto& value : values) {
    const Witness w = read("facets.paired", {value});
    EXPECT_FALSE(w.has_figure()) << value.first << " " << value.second;
    EXPECT_EQ(w.notes.size(), 1U) << value.first << " " << value.second;
  }
  // A number of a megabyte is not read; a control character does not reach the picture.
  EXPECT_FALSE(read("delaunay.empty", {{"cell-points", "(" + std::string(1000000, '9') + ",0);(0,0);(0,1)"}})
                   .has_figure());
  EXPECT_EQ(read("cells.nondegenerate", {{"cell", "\x01\xff"}}).sentence, "cell ?? has volume 0");
  EXPECT_EQ(read("unheard.of", {{"edge", "?"}}).sentence, "the condition fails");
}

TEST_F(RefutationTest, TheFirstConditionWithAFigureIsChosen) {
  const Verdict verdict{"REFUTED",
                        {{"volume.exact", {}},
                         {"vertices.complete", {{"point", "2"}}},
                         {"links.spheres", {{"vertex", "[1,0|1;0,1|0]*2"}}}}};
  EXPECT_EQ(chosen_witness(verdict, "", instance, triangulation)->condition, "links.spheres");
  EXPECT_EQ(chosen_witness(verdict, "volume.exact", instance, triangulation)->condition, "volume.exact");
  EXPECT_EQ(chosen_witness({"REFUTED", {{"volume.exact", {}}}}, "", instance, triangulation)->condition,
            "volume.exact");
  EXPECT_EQ(chosen_witness({"REFUTED", {{"volume.exact", {}}, {"vertices.complete", {{"point", "2"}}}}}, "",
                           instance, triangulation)
                ->condition,
            "vertices.complete");
  EXPECT_FALSE(chosen_witness({"VERIFIED", {}}, "", instance, triangulation));
  EXPECT_THROW(chosen_witness(verdict, "group.name", instance, triangulation), InvalidInput);
}

TEST(CircumscribedBall, OfAFlatCellThereIsNone) {
  const auto point = [](int x, int y, int z) {
    Vector p(3);
    p[0] = x;
    p[1] = y;
    p[2] = z;
    return p;
  };
  const Matrix gram = Matrix::identity(3);
  EXPECT_FALSE(circumscribed_ball(gram, {point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(1, 1, 0)}));
  const auto ball =
      circumscribed_ball(gram, {point(0, 0, 0), point(2, 0, 0), point(0, 2, 0), point(0, 0, 2)});
  ASSERT_TRUE(ball);
  EXPECT_EQ(ball->centre.to_string(), "1 1 1");
  EXPECT_EQ(ball->radius_squared.to_string(), "3");
}

}  // namespace
}  // namespace flatdt::ref
