// The analysis of the instance's group: the twelve manifolds in any description, and groups that must be
// refused.
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

std::string instance_text(const Known& known) {
  return "flatdt-instance 1 dimension " + std::to_string(known.dimension) + " manifold " + known.name +
         " points 1 0 0 " + (known.dimension == 3 ? "0 " : "");
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

// The largest point groups are taken whole: 12 and 48 linear parts are not too many.
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
