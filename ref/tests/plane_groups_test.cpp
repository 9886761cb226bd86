/// The 17 plane groups: p1 and pg act freely, each of the others is refused with a fixed point.
#include <gtest/gtest.h>

#include <set>

#include "group_samples.hpp"

namespace flatdt::ref::testing {
namespace {

struct PlaneGroup {
  std::string name;
  /// Besides the translations by 1 along both axes; augmented matrices row by row.
  std::vector<std::vector<Rational>> generators;
};

const Rational kHalf(Integer(1), Integer(2));

/// Source: International Tables for Crystallography A, plane groups 1 to 17, standard settings.
const std::vector<PlaneGroup>& plane_groups() {
  static const std::vector<Rational> half_turn = {-1, 0, 0, 0, -1, 0};
  static const std::vector<Rational> mirror_x = {-1, 0, 0, 0, 1, 0};
  static const std::vector<Rational> centring = {1, 0, kHalf, 0, 1, kHalf};
  static const std::vector<Rational> turn_3 = {0, -1, 0, 1, -1, 0};
  static const std::vector<Rational> turn_4 = {0, -1, 0, 1, 0, 0};
  static const std::vector<Rational> turn_6 = {1, -1, 0, 1, 0, 0};
  static const std::vector<Rational> swap = {0, 1, 0, 1, 0, 0};
  static const std::vector<PlaneGroup> groups = {
      {"p1", {}},
      {"p2", {half_turn}},
      {"pm", {mirror_x}},
      {"pg", {{-1, 0, 0, 0, 1, kHalf}}},
      {"cm", {mirror_x, centring}},
      {"p2mm", {half_turn, mirror_x}},
      {"p2mg", {half_turn, {-1, 0, kHalf, 0, 1, 0}}},
      {"p2gg", {half_turn, {-1, 0, kHalf, 0, 1, kHalf}}},
      {"c2mm", {half_turn, mirror_x, centring}},
      {"p4", {turn_4}},
      {"p4mm", {turn_4, mirror_x}},
      {"p4gm", {turn_4, {-1, 0, kHalf, 0, 1, kHalf}}},
      {"p3", {turn_3}},
      {"p3m1", {turn_3, {0, -1, 0, -1, 0, 0}}},
      {"p31m", {turn_3, swap}},
      {"p6", {turn_6}},
      {"p6mm", {turn_6, swap}},
  };
  return groups;
}

Isometry modulo_1(Isometry g) {
  for (int i = 0; i < g.dimension(); ++i) g.translation[i] -= Rational(floor(g.translation[i]));
  return g;
}

/// The elements modulo Z^2, by multiplying until nothing new appears.
std::set<Isometry> closed(const std::vector<Isometry>& generators) {
  std::set<Isometry> elements = {Isometry::identity(2)};
  std::size_t size = 0;
  while (size != elements.size()) {
    size = elements.size();
    const std::set<Isometry> old = elements;
    for (const Isometry& g : old)
      for (const Isometry& h : generators) elements.insert(modulo_1(g * h));
  }
  return elements;
}

TEST(PlaneGroups, OnlyP1AndPgActFreely) {
  ASSERT_EQ(plane_groups().size(), 17U);
  std::mt19937_64 random(1);
  for (const PlaneGroup& group : plane_groups()) {
    std::vector<Isometry> generators = {Isometry::translate(make_vector({1, 0})),
                                        Isometry::translate(make_vector({0, 1}))};
    for (const auto& e : group.generators)
      generators.push_back({make_matrix(2, {e[0], e[1], e[3], e[4]}), make_vector({e[2], e[5]})});
    const std::set<Isometry> elements = closed(generators);
    const std::vector<Isometry> point_group(elements.begin(), elements.end());
    for (int repetition = 0; repetition < 50; ++repetition) {
      const Isometry map = repetition == 0 ? Isometry::identity(2)
                                           : Isometry{random_unimodular(2, random), random_origin(2, random)};
      const Instance instance =
          moved(make_instance(generators, averaged(random_metric(2, random), point_group)), map.linear,
                map.translation);
      try {
        const GroupAnalysis analysis = analyse(instance);
        EXPECT_TRUE(group.name == "p1" || group.name == "pg") << group.name;
        EXPECT_EQ(analysis.entry, find_entry(group.name));
        expect_frame_holds(analysis, instance.gram);
      } catch (const FixedPointError& error) {
        EXPECT_TRUE(group.name != "p1" && group.name != "pg") << group.name << ": " << error.what();
        EXPECT_FALSE(error.element().is_identity());
        EXPECT_EQ(error.element() * error.point(), error.point());
        EXPECT_TRUE(elements.count(modulo_1(map.inverse() * error.element() * map)) > 0) << group.name;
      }
    }
  }
}

}  // namespace
}  // namespace flatdt::ref::testing
