// Subgroups of finite index: membership, index, right cosets.
#include "subgroup.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "build.hpp"
#include "linear.hpp"
#include "orbits.hpp"

namespace flatdt::checker::test {
namespace {

using enum ConditionName;

Group named_group(const std::string& name, int d) {
  const Instance instance = read_instance("flatdt-instance 1 dimension " + std::to_string(d) + " manifold " +
                                          name + " points 1 0 0 " + (d == 3 ? "0 " : ""));
  return make_group(std::get<Crystal>(close_group(d, instance.generators, &instance.metric)));
}

std::vector<Seitz> elements(const std::string& text, int count, int d) {
  return *read_triangulation(
              "flatdt-triangulation 1 subgroup " + std::to_string(count) + " " + text + "elements 0 cells 0 ",
              read_instance(d == 2 ? "flatdt-instance 1 dimension 2 manifold torus points 1 0 0 "
                                   : "flatdt-instance 1 dimension 3 manifold P1 points 1 0 0 0 "))
              .subgroup;
}

struct Case {
  const char* group;
  int dimension;
  int count;
  const char* generators;
  int index;
  const char* homology;
};
const Case kCases[] = {
    {"torus", 2, 2, "1 0 2 0 1 1 1 0 0 0 1 3 ", 6, "Z^2"},
    {"klein-bottle", 2, 2, "1 0 1 0 1 0 1 0 0 0 1 1 ", 2, "Z^2"},
    // Index 3, not normal: <3x, glide>, a Klein bottle.
    {"klein-bottle", 2, 2, "1 0 3 0 1 0 -1 0 0 0 1 1/2 ", 3, "Z+Z/2"},
    // Index 3, the other direction: <x, glide^3>.
    {"klein-bottle", 2, 2, "1 0 1 0 1 0 -1 0 0 0 1 3/2 ", 3, "Z+Z/2"},
    {"didicosm", 3, 3, "1 0 0 1 0 1 0 0 0 0 1 0 1 0 0 0 0 1 0 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1 1 ", 4, "Z^3"},
    // The dicosm inside the didicosm, index 2.
    {"didicosm", 3, 4,
     "1 0 0 1 0 1 0 0 0 0 1 0 1 0 0 0 0 1 0 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1 1 -1 0 0 1/2 0 -1 0 0 0 0 1 1/2 ",
     2, "Z+Z/2+Z/2"},
    // Index 5 in the tetracosm: the screw and a sublattice of index 5 that it keeps.
    {"tetracosm", 3, 2, "0 -1 0 0 1 0 0 0 0 0 1 1/4 1 0 0 2 0 1 0 1 0 0 1 0 ", 5, "Z+Z/2"},
    // Index 9, not normal: the screw with 3 Z^2.
    {"tetracosm", 3, 2, "0 -1 0 0 1 0 0 0 0 0 1 1/4 1 0 0 3 0 1 0 0 0 0 1 0 ", 9, "Z+Z/2"},
    {"first-amphidicosm", 3, 3, "1 0 0 1/2 0 -1 0 0 0 0 1 0 1 0 0 0 0 1 0 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1 1 ",
     2, "Z^2+Z/2"},
};

TEST(Subgroup, IndexVolumeAndHomology) {
  for (const Case& c : kCases) {
    const Group group = named_group(c.group, c.dimension);
    const std::vector<Seitz> generators = elements(c.generators, c.count, c.dimension);
    const auto made = Subgroup::make(group, &generators);
    const Subgroup* subgroup = std::get_if<Subgroup>(&made);
    ASSERT_NE(subgroup, nullptr) << c.group;
    EXPECT_EQ(subgroup->index(), c.index) << c.group;
    EXPECT_EQ(subgroup->volume() * static_cast<unsigned long>(group.order()), c.index);
    EXPECT_EQ(to_string(first_homology(subgroup->own())), c.homology) << c.group;
  }
}

// The number of right cosets met by random elements is the index; Hg = Hg' iff g' g^-1 is in H, by Seitz
// matrices.
TEST(Subgroup, CosetsAreTheIndexAndCanonical) {
  std::mt19937 random(5);
  for (const Case& c : kCases) {
    const Group group = named_group(c.group, c.dimension);
    const std::vector<Seitz> generators = elements(c.generators, c.count, c.dimension);
    const auto made = Subgroup::make(group, &generators);
    const Subgroup& subgroup = std::get<Subgroup>(made);
    ElementTable table(group);
    std::set<ElementId> cosets;
    ElementId previous = kIdentity;
    for (int round = 0; round < 600; ++round) {
      Element e{static_cast<std::uint8_t>(random() % group.order()), {}};
      for (std::size_t i = 0; i < static_cast<std::size_t>(c.dimension); ++i) {
        e.shift[i] = static_cast<long>(random() % 41) - 20;
      }
      const ElementId g = table.intern(e);
      const CosetPosition position = subgroup.locate(table, g);
      cosets.insert(position.representative);
      EXPECT_EQ(table.product(position.transport, position.representative), g);
      // transport lies in H: its coset is H itself.
      EXPECT_EQ(subgroup.locate(table, position.transport).representative,
                subgroup.locate(table, kIdentity).representative);
      const Element quotient = group.multiply(table[g], group.invert(table[previous]));
      const Seitz inner = group.lattice_seitz(quotient);  // outer coordinates of `own` are the lattice's of G
      EXPECT_EQ(subgroup.own().locate(inner).has_value(),
                position.representative == subgroup.locate(table, previous).representative);
      for (const Seitz& h : generators) {
        const ElementId moved = table.product(table.intern(*group.locate(h)), g);
        EXPECT_EQ(subgroup.locate(table, moved).representative, position.representative);
      }
      previous = g;
    }
    EXPECT_EQ(cosets.size(), static_cast<std::size_t>(c.index)) << c.group;
  }
}

TEST(Subgroup, IndexIsABigInteger) {
  const std::string big = "1" + std::string(30, '0');
  const Verdict v = judge(
      "flatdt-instance 1 dimension 2 manifold torus points 1 0 0 ",
      "flatdt-triangulation 1 subgroup 2 1 0 " + big + " 0 1 0 1 0 0 0 1 " + big + " elements 0 cells 0 ");
  EXPECT_EQ(witness(v, subgroup_member, "index"), "1" + std::string(60, '0'));
  EXPECT_EQ(v[vertices_complete].status, Status::fails);
}

TEST(Subgroup, MembershipOfGeneratorsAndElements) {
  const std::string klein = "flatdt-instance 1 dimension 2 manifold klein-bottle points 1 0 0 ";
  const auto judged = [&](const std::string& text) { return judge(klein, "flatdt-triangulation 1 " + text); };
  const struct {
    std::string text;
    const char* reason;
  } cases[] = {
      {"subgroup 1 1 0 1/2 0 1 0 elements 0 cells 0 ", "subgroup-generator-not-in-group"},
      {"subgroup 3 1 0 1 0 1 0 1 0 0 0 1 1 1 0 0 0 -1 0 elements 0 cells 0 ",
       "subgroup-generator-not-in-group"},
      {"subgroup 0 elements 0 cells 0 ", "infinite-index"},
      {"subgroup 1 -1 0 0 0 1 1/2 elements 0 cells 0 ", "infinite-index"},
      {"subgroup 2 1 0 1 0 1 0 1 0 3 0 1 0 elements 0 cells 0 ", "infinite-index"},
      {"elements 2 1 0 1 0 1 0 1 0 0 0 1 1/2 cells 0 ", "element-not-in-group"},
      {"elements 1 -1 0 0 0 1 0 cells 0 ", "element-not-in-group"},
      {"elements 1 1 1 0 0 1 0 cells 0 ", "element-not-in-group"},
      {"elements 1 0 0 0 0 0 0 cells 0 ", "element-not-in-group"},
  };
  for (const auto& c : cases) {
    const Verdict v = judged(c.text);
    EXPECT_EQ(statuses(v), "hhh f ssssss ssss s ssss") << c.text;
    EXPECT_EQ(v.outcome, Outcome::refuted);
    EXPECT_EQ(witness(v, subgroup_member, "reason"), c.reason) << c.text;
  }
}

TEST(Orbits, PointsOfOneOrbitAreOnePoint) {
  const Instance instance = read_instance(
      "flatdt-instance 1 dimension 2 manifold klein-bottle points 6 1/3 1/5 2/3 7/10 1/3 1/7 7/3 -9/5 -1/3 "
      "-3/10 1/3 6/7 ");
  const Group group = named_group("klein-bottle", 2);
  for (const bool fixed_width : {true, false}) {
    ElementTable table(group);
    const Orbits orbits = make_orbits(instance, table, fixed_width);
    EXPECT_EQ(orbits.fixed.has_value(), fixed_width);
    EXPECT_EQ(orbits.count(), 3U);
    EXPECT_EQ(orbits.of_point,
              (std::vector{OrbitId{0}, OrbitId{0}, OrbitId{1}, OrbitId{0}, OrbitId{0}, OrbitId{2}}));
    EXPECT_EQ(orbits.first_point[2], PointId{5});
    for (std::size_t i = 0; i < 6; ++i) {  // point = frame * canonical
      const std::size_t orbit = index(orbits.of_point[i]);
      Vec<Rational> x;
      for (std::size_t k = 0; k < 2; ++k) {
        x[k] = fixed_width
                   ? Rational(orbits.fixed->numerator[orbit][k], orbits.fixed->denominator)
                   : Rational(orbits.canonical[orbit].numerator[k], orbits.canonical[orbit].denominator);
        x[k].canonicalize();
      }
      EXPECT_EQ(apply(2, group.outer_seitz(table[orbits.frame[i]]), x), instance.points[i]);
    }
  }
}

}  // namespace
}  // namespace flatdt::checker::test
