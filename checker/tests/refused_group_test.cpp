// Groups that must be refused: with torsion, shown by a fixed point, or not crystallographic.
#include "group.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "build.hpp"
#include "catalogue.hpp"
#include "judge_group.hpp"
#include "linear.hpp"

namespace flatdt::checker::test {
namespace {

using enum ConditionName;

// Generators, and the fixed point's element recomputed by hand from the witness.
TEST(RefusedGroup, TorsionIsRefusedWithAFixedPoint) {
  const std::string square = "1 0 1 0 1 0 1 0 0 0 1 1 ";
  const std::string cube = "1 0 0 1 0 1 0 0 0 0 1 0 1 0 0 0 0 1 0 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1 1 ";
  const struct {
    const char* name;
    int dimension;
    int count;
    std::string generators;
    const char* metric;
  } cases[] = {
      {"p2", 2, 3, square + "-1 0 1/3 0 -1 5 ", "1 0 1"},
      {"pm", 2, 3, square + "-1 0 1/2 0 1 0 ", "1 0 1"},
      {"cm", 2, 3, square + "0 1 1/2 1 0 -1/2 ", "1 0 1"},
      {"cm, glide given only", 2, 4, square + "1 0 1/2 0 1 1/2 1 0 1/2 0 -1 0 ", "1 0 1"},
      {"pmg", 2, 4, square + "-1 0 0 0 -1 0 -1 0 1/2 0 1 0 ", "1 0 1"},
      {"pgg", 2, 4, square + "-1 0 0 0 -1 0 -1 0 1/2 0 1 1/2 ", "1 0 1"},
      {"p3", 2, 3, square + "0 -1 1/2 1 -1 0 ", "1 -1/2 1"},
      {"p4", 2, 3, square + "0 -1 0 1 0 1/2 ", "1 0 1"},
      {"p6m", 2, 4, square + "1 -1 0 1 0 0 0 1 0 1 0 0 ", "1 -1/2 1"},
      {"P2", 3, 4, cube + "-1 0 0 0 0 -1 0 0 0 0 1 0 ", "1 0 0 1 0 1"},
      {"Pm", 3, 4, cube + "1 0 0 0 0 -1 0 1/7 0 0 1 0 ", "1 0 0 1 0 1"},
      {"P-1", 3, 4, cube + "-1 0 0 1/3 0 -1 0 0 0 0 -1 2/5 ", "1 1/3 1/4 1 1/5 1"},
      {"C2", 3, 5, cube + "1 0 0 1/2 0 1 0 1/2 0 0 1 0 -1 0 0 0 0 1 0 1/2 0 0 -1 0 ", "1 0 0 1 0 1"},
      {"P222_1", 3, 5, cube + "-1 0 0 0 0 -1 0 0 0 0 1 1/2 1 0 0 0 0 -1 0 0 0 0 -1 0 ", "1 0 0 1 0 1"},
      {"I2_12_12_1", 3, 6,
       cube + "1 0 0 1/2 0 1 0 1/2 0 0 1 1/2 -1 0 0 1/2 0 -1 0 0 0 0 1 1/2 -1 0 0 0 0 1 0 1/2 0 0 -1 1/2 ",
       "1 0 0 1 0 1"},
      {"P4_2", 3, 4, cube + "0 -1 0 0 1 0 0 0 0 0 1 1/2 ", "1 0 0 1 0 1"},
      {"Pm-3m", 3, 6, cube + "0 0 1 0 1 0 0 0 0 1 0 0 0 -1 0 0 1 0 0 0 0 0 1 0 -1 0 0 0 0 -1 0 0 0 0 -1 0 ",
       "1 0 0 1 0 1"},
      {"only torsion, no lattice given", 2, 2, "-1 0 0 0 -1 0 -1 0 1 0 -1 0 ", "1 0 1"},
  };
  for (const auto& c : cases) {
    const Instance instance =
        read_instance("flatdt-instance 1 dimension " + std::to_string(c.dimension) + " generators " +
                      std::to_string(c.count) + " " + c.generators + "metric " + c.metric + " points 1 0 0 " +
                      (c.dimension == 3 ? "0 " : ""));
    const Verdict verdict = judge_group(instance);
    EXPECT_EQ(verdict.outcome, Outcome::malformed) << c.name;
    if (std::string(c.name).starts_with("only")) {
      EXPECT_EQ(witness(verdict, group_crystallographic, "reason"), "not-cocompact");
      continue;
    }
    EXPECT_EQ(statuses(verdict), "hfs s ssssss ssss s ssss") << c.name;
    EXPECT_NE(verdict.reason.find("fixed-point="), std::string::npos);
    const Group group = group_of(instance);
    const std::optional<TorsionElement> torsion = find_torsion(group);
    ASSERT_TRUE(torsion.has_value()) << c.name;
    EXPECT_TRUE(group.locate(torsion->element).has_value()) << c.name;
    EXPECT_EQ(apply(c.dimension, torsion->element, torsion->fixed_point), torsion->fixed_point) << c.name;
    EXPECT_NE(torsion->element.linear, identity<Rational>(c.dimension)) << c.name;
    EXPECT_EQ(witness(verdict, group_torsion_free, "element"), to_string(c.dimension, torsion->element));
  }
}

TEST(RefusedGroup, NotCrystallographic) {
  const std::string head = "flatdt-instance 1 dimension 2 generators ";
  const auto reason = [](const Verdict& v) { return witness(v, group_crystallographic, "reason"); };
  // Not an isometry: a shear, a scaling, and a rotation of the wrong metric.
  for (const std::string generator : {"1 1 0 0 1 0 ", "2 0 0 0 2 0 ", "0 0 0 0 0 0 ", "0 -1 0 1 -1 0 "}) {
    const Verdict v = judge_group(head + "3 1 0 1 0 1 0 1 0 0 0 1 1 " + generator + "points 1 0 0 ");
    EXPECT_EQ(reason(v), "metric-not-invariant") << generator;
    EXPECT_EQ(witness(v, group_crystallographic, "generator"), "2");
    EXPECT_EQ(statuses(v), "fss s ssssss ssss s ssss");
    EXPECT_EQ(v.outcome, Outcome::malformed);
  }
  // A rotation of infinite order, alone and as a product of two reflections of order 2.
  EXPECT_EQ(reason(judge_group(head + "1 3/5 -4/5 0 4/5 3/5 0 points 1 0 0 ")), "infinite-order");
  EXPECT_EQ(reason(judge_group(head + "2 1 0 0 0 -1 0 3/5 4/5 0 4/5 -3/5 0 points 1 0 0 ")),
            "infinite-order");
  // Rank too small.
  EXPECT_EQ(reason(judge_group(head + "1 1 0 1 0 1 0 points 1 0 0 ")), "not-cocompact");
  EXPECT_EQ(reason(judge_group(head + "2 1 0 1 0 1 0 1 0 1/3 0 1 0 points 1 0 0 ")), "not-cocompact");
  EXPECT_EQ(reason(judge_group(head + "1 -1 0 0 0 1 1/2 points 1 0 0 ")), "not-cocompact");
  EXPECT_EQ(reason(judge_group(head + "1 1 0 0 0 1 0 points 1 0 0 ")), "not-cocompact");
}

// Among isometries an element of infinite order has always come up first; the cap is what bounds the loop
// whatever the linear parts. Shears have integral traces and keep no metric, so they reach it: the 13th and
// the 49th are named.
TEST(RefusedGroup, TheNumberOfLinearPartsIsCapped) {
  for (const int d : {2, 3}) {
    Seitz shear{identity<Rational>(d), {}};
    shear.linear[0][1] = 1;
    const std::variant<Crystal, Witness> closed = close_group(d, {shear}, nullptr);
    const Witness* refused = std::get_if<Witness>(&closed);
    ASSERT_NE(refused, nullptr);
    const Witness expected = {{"reason", "point-group-too-large"},
                              {"linear-parts", d == 2 ? "13" : "49"},
                              {"element", d == 2 ? "[1,12|0;0,1|0]" : "[1,48,0|0;0,1,0|0;0,0,1|0]"}};
    EXPECT_EQ(*refused, expected);
  }
}

}  // namespace
}  // namespace flatdt::checker::test
