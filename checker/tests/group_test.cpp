// The analysis of the instance's group: the twelve manifolds in any description, and groups that must be
// refused.
#include "group.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "build.hpp"
#include "catalogue.hpp"
#include "linear.hpp"

namespace flatdt::checker::test {
namespace {

using enum ConditionName;

struct Known {
  const char* name;
  int dimension;
  const char* holonomy;
  const char* homology;
};
const Known kKnown[] = {{"torus", 2, "1", "Z^2"},
                        {"klein-bottle", 2, "Z2", "Z+Z/2"},
                        {"torocosm", 3, "1", "Z^3"},
                        {"dicosm", 3, "Z2", "Z+Z/2+Z/2"},
                        {"tricosm", 3, "Z3", "Z+Z/3"},
                        {"P32", 3, "Z3", "Z+Z/3"},
                        {"tetracosm", 3, "Z4", "Z+Z/2"},
                        {"P43", 3, "Z4", "Z+Z/2"},
                        {"hexacosm", 3, "Z6", "Z"},
                        {"P65", 3, "Z6", "Z"},
                        {"didicosm", 3, "Z2xZ2", "Z/4+Z/4"},
                        {"first-amphicosm", 3, "Z2", "Z^2+Z/2"},
                        {"second-amphicosm", 3, "Z2", "Z^2"},
                        {"first-amphidicosm", 3, "Z2xZ2", "Z+Z/2+Z/2"},
                        {"second-amphidicosm", 3, "Z2xZ2", "Z+Z/4"}};

Group group_of(const Instance& instance) {
  return make_group(
      std::get<Crystal>(close_group(instance.dimension, instance.generators, &instance.metric)));
}

std::string instance_text(const Known& known) {
  return "flatdt-instance 1 dimension " + std::to_string(known.dimension) + " manifold " + known.name +
         " points 1 0 0 " + (known.dimension == 3 ? "0 " : "");
}

/// Verdict on the instance with an empty triangulation: only the group conditions matter.
Verdict judge_group(const Instance& instance) {
  return check(instance, read_triangulation("flatdt-triangulation 1 elements 0 cells 0 ", instance));
}

Verdict judge_group(const std::string& text) {
  return judge_group(read_instance(text));
}

Integer draw(std::mt19937& random, long most) {
  return static_cast<long>(random() % (2 * most + 1)) - most;
}

TEST(Group, TheTwelveManifolds) {
  for (const Known& known : kKnown) {
    const Instance instance = read_instance(instance_text(known));
    const Group group = group_of(instance);
    EXPECT_EQ(holonomy_name(group), known.holonomy) << known.name;
    EXPECT_EQ(to_string(first_homology(group)), known.homology) << known.name;
    EXPECT_EQ(abs(determinant(known.dimension, group.basis)), 1)
        << known.name;  // the catalogue's lattice is Z^d
    EXPECT_FALSE(find_torsion(group).has_value()) << known.name;
    EXPECT_EQ(judge_group(instance)[group_name].status, Status::holds) << known.name;
  }
}

// x = A y + o with A rational, plus redundant generators: the same claim, whatever the description.
TEST(Group, AnyAffineBasisOriginAndGenerators) {
  std::mt19937 random(7);
  for (const Known& known : kKnown) {
    for (int round = 0; round < 6; ++round) {
      Instance instance = read_instance(instance_text(known));
      const int d = known.dimension;
      Mat<Rational> a;
      do {
        for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
          for (std::size_t j = 0; j < static_cast<std::size_t>(d); ++j) {
            a[i][j] = Rational(draw(random, 4), 1 + random() % 3);
            a[i][j].canonicalize();
          }
        }
      } while (determinant(d, a) == 0);
      const Mat<Rational> b = inverse(d, a);
      Seitz origin{identity<Rational>(d), {}};
      Seitz back = origin;
      for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
        origin.translation[i] = Rational(draw(random, 9), 7);
        origin.translation[i].canonicalize();
        back.translation[i] = -origin.translation[i];
      }
      for (Seitz& g : instance.generators) g = change_basis(d, compose(d, back, compose(d, g, origin)), a, b);
      instance.metric = multiply(d, transpose(a), multiply(d, instance.metric, a));
      for (int k = 0; k < 5; ++k) {
        const std::size_t n = instance.generators.size();
        instance.generators.insert(instance.generators.begin(), compose(d, instance.generators[random() % n],
                                                                        instance.generators[random() % n]));
      }
      const Verdict verdict = judge_group(instance);
      EXPECT_EQ(verdict[group_name].status, Status::holds) << known.name << ": " << verdict.reason;
      EXPECT_EQ(abs(determinant(d, group_of(instance).basis)), abs(determinant(d, b)));
    }
  }
}

TEST(Group, EveryOtherNameIsRefused) {
  for (const Known& known : kKnown) {
    for (const Known& claim : kKnown) {
      if (known.dimension != claim.dimension) continue;
      Instance instance = read_instance(instance_text(known));
      const std::string truth = *instance.claim;
      instance.claim = std::string(find_manifold(claim.name)->name);
      const Verdict verdict = judge_group(instance);
      const bool same = truth == *instance.claim;
      EXPECT_EQ(verdict[group_name].status, same ? Status::holds : Status::fails)
          << truth << " as " << claim.name;
      if (same) continue;
      EXPECT_EQ(verdict.outcome, Outcome::malformed);
      EXPECT_EQ(statuses(verdict), "hhf s ssssss ssss s ssss");
      EXPECT_EQ(witness(verdict, group_name, "manifold"), truth);
    }
  }
}

TEST(Group,
     CentredLatticeIsFound) {  // cm-like centring of the torus: the primitive lattice has index 2 over Z^2
  const Instance instance = read_instance(
      "flatdt-instance 1 dimension 2 generators 3 1 0 1 0 1 0 1 0 0 0 1 1 1 0 1/2 0 1 1/2 points 1 0 0 ");
  EXPECT_EQ(abs(determinant(2, group_of(instance).basis)), Rational(1, 2));
  EXPECT_EQ(judge_group(instance)[group_torsion_free].status, Status::holds);
}

// Generators, and the fixed point's element recomputed by hand from the witness.
TEST(Group, TorsionIsRefusedWithAFixedPoint) {
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

TEST(Group, NotCrystallographic) {
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

// Rational reflections whose products of few factors all have integral traces do not exist in bulk; the cap
// itself is reached by a finite group that is none of a lattice: the 24 linear parts below are fine, 49 never
// occur.
TEST(Group, FullHolohedriesAreFinite) {
  const std::string cube = "1 0 0 1 0 1 0 0 0 0 1 0 1 0 0 0 0 1 0 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1 1 ";
  const Instance cubic =
      read_instance("flatdt-instance 1 dimension 3 generators 6 " + cube +
                    "0 0 1 0 1 0 0 0 0 1 0 0 0 -1 0 0 1 0 0 0 0 0 1 0 -1 0 0 0 0 -1 0 0 0 0 -1 0 "
                    "points 1 0 0 0 ");
  EXPECT_EQ(group_of(cubic).order(), 48U);
  const Instance hexagonal = read_instance(
      "flatdt-instance 1 dimension 2 generators 4 1 0 1 0 1 0 1 0 0 0 1 1 1 -1 0 1 0 0 0 1 0 1 0 0 metric 1 "
      "-1/2 1 "
      "points 1 0 0 ");
  EXPECT_EQ(group_of(hexagonal).order(), 12U);
}

TEST(Group, WrongMetricForACatalogueName) {
  const Verdict v =
      judge_group("flatdt-instance 1 dimension 3 manifold tetracosm metric 1 0 0 2 0 1 points 1 0 0 0 ");
  EXPECT_EQ(witness(v, group_crystallographic, "reason"), "metric-not-invariant");
  EXPECT_EQ(v.reason.substr(0, 11), "instance:1:");
}

// Multiplication and inversion in (rotation, shift) form against Seitz matrices.
TEST(Group, ElementArithmeticAgreesWithSeitzMatrices) {
  std::mt19937 random(3);
  for (const Known& known : kKnown) {
    const Group group = group_of(read_instance(instance_text(known)));
    const int d = known.dimension;
    for (int round = 0; round < 30; ++round) {
      const auto random_element = [&] {
        Element e{static_cast<std::uint8_t>(random() % group.order()), {}};
        for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) e.shift[i] = draw(random, 50);
        return e;
      };
      const Element a = random_element();
      const Element b = random_element();
      const Seitz product = compose(d, group.outer_seitz(a), group.outer_seitz(b));
      EXPECT_EQ(group.locate(product), group.multiply(a, b));
      EXPECT_EQ(group.multiply(a, group.invert(a)), Element{});
      EXPECT_EQ(group.multiply(group.invert(a), a), Element{});
    }
  }
}

}  // namespace
}  // namespace flatdt::checker::test
