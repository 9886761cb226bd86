/// Every setting of all 230 space-group types in gemmi's table (559 settings): the 13 torsion-free types are
/// recognised, every other is refused with a fixed point, which is verified here.
#include <gtest/gtest.h>

#include <gemmi/symmetry.hpp>
#include <map>
#include <set>

#include "group_samples.hpp"

namespace flatdt::ref::testing {
namespace {

const std::map<int, std::string>& torsion_free_types() {
  static const std::map<int, std::string> types = {{1, "torocosm"},
                                                   {4, "dicosm"},
                                                   {7, "first-amphicosm"},
                                                   {9, "second-amphicosm"},
                                                   {19, "didicosm"},
                                                   {29, "first-amphidicosm"},
                                                   {33, "second-amphidicosm"},
                                                   {76, "tetracosm"},
                                                   {78, "tetracosm"},
                                                   {144, "tricosm"},
                                                   {145, "tricosm"},
                                                   {169, "hexacosm"},
                                                   {170, "hexacosm"}};
  return types;
}

bool is_mirror_image(int number) {
  return number == 78 || number == 145 || number == 170;
}

/// A setting as the table has it: operations modulo the lattice that Z^3 and the centring vectors generate.
struct Setting {
  int number;
  std::string name;
  std::vector<Isometry> operations;
  std::vector<Vector> centring;

  /// Membership, from the table alone.
  [[nodiscard]] bool has(const Isometry& g) const {
    for (const Isometry& op : operations)
      for (const Vector& c : centring)
        if (op.linear == g.linear && (g.translation - op.translation - c).is_integral()) return true;
    return false;
  }
  [[nodiscard]] Instance instance(std::mt19937_64& random) const {
    std::vector<Isometry> generators = operations;
    for (const Vector& c : centring) generators.push_back(Isometry::translate(c));
    for (int i = 0; i < 3; ++i) generators.push_back(Isometry::translate(Matrix::identity(3).column(i)));
    return make_instance(generators, averaged(random_metric(3, random), operations));
  }
};

Rational over_den(int numerator) {
  return {Integer(numerator), Integer(gemmi::Op::DEN)};
}

std::vector<Setting> all_settings() {
  std::vector<Setting> settings;
  for (const gemmi::SpaceGroup& type : gemmi::spacegroup_tables::main) {
    Setting setting{type.number, type.xhm(), {}, {}};
    const gemmi::GroupOps table = type.operations();
    for (const gemmi::Op& op : table.sym_ops) {
      Isometry g = Isometry::identity(3);
      for (int i = 0; i < 3; ++i) {
        const auto row = static_cast<std::size_t>(i);
        for (int j = 0; j < 3; ++j) g.linear(i, j) = over_den(op.rot[row][static_cast<std::size_t>(j)]);
        g.translation[i] = over_den(op.tran[row]);
      }
      setting.operations.push_back(g);
    }
    for (const auto& c : table.cen_ops)
      setting.centring.push_back(make_vector({over_den(c[0]), over_den(c[1]), over_den(c[2])}));
    settings.push_back(setting);
  }
  return settings;
}

/// Analyses the setting in the coordinates y = map x and compares with the table.
void expect_right_answer(const Setting& setting, const Instance& original, const Isometry& map) {
  const Instance instance = moved(original, map.linear, map.translation);
  const auto type = torsion_free_types().find(setting.number);
  if (type == torsion_free_types().end()) {
    try {
      analyse(instance);
      ADD_FAILURE() << setting.name << " was accepted";
    } catch (const FixedPointError& error) {
      EXPECT_FALSE(error.element().is_identity()) << setting.name;
      EXPECT_EQ(error.element() * error.point(), error.point()) << setting.name;
      EXPECT_TRUE(setting.has(map.inverse() * error.element() * map)) << setting.name;
    }
    return;
  }
  const GroupAnalysis analysis = analyse(instance);
  EXPECT_EQ(analysis.entry->name, type->second) << setting.name;
  const bool reflected = map.linear.determinant().sign() == Sign::negative;
  const bool chiral = !analysis.entry->mirror_image_generators.empty();
  EXPECT_EQ(analysis.frame.mirrored, chiral && is_mirror_image(setting.number) != reflected) << setting.name;
  expect_frame_holds(analysis, instance.gram);
}

TEST(SpaceGroups, TheTableIsComplete) {
  std::set<int> numbers;
  int torsion_free = 0;
  for (const Setting& setting : all_settings()) {
    numbers.insert(setting.number);
    torsion_free += static_cast<int>(torsion_free_types().count(setting.number));
  }
  EXPECT_EQ(numbers.size(), 230U);
  EXPECT_EQ(torsion_free, 56);
}

TEST(SpaceGroups, EverySettingAsInTheTable) {
  std::mt19937_64 random(1);
  for (const Setting& setting : all_settings())
    expect_right_answer(setting, setting.instance(random), Isometry::identity(3));
}

TEST(SpaceGroups, EverySettingInOtherCoordinates) {
  std::mt19937_64 random(2);
  for (const Setting& setting : all_settings()) {
    const int repetitions = torsion_free_types().count(setting.number) > 0 ? 10 : 1;
    for (int k = 0; k < repetitions; ++k) {
      const Isometry map{random_unimodular(3, random), random_origin(3, random)};
      expect_right_answer(setting, setting.instance(random), map);
    }
  }
}

TEST(SpaceGroups, DeltaDoesNotDependOnCoordinates) {
  std::mt19937_64 random(3);
  for (const Setting& setting : all_settings()) {
    if (torsion_free_types().count(setting.number) == 0) continue;
    const Instance instance = setting.instance(random);
    const GroupAnalysis here = analyse(instance);
    const Vector origin = random_origin(3, random);
    const GroupAnalysis there = analyse(moved(instance, random_unimodular(3, random), origin));
    EXPECT_EQ(here.frame.delta_squared, there.frame.delta_squared) << setting.name;
    EXPECT_EQ(here.volume_squared, there.volume_squared) << setting.name;
    EXPECT_EQ(here.h1, there.h1) << setting.name;
  }
}

}  // namespace
}  // namespace flatdt::ref::testing
