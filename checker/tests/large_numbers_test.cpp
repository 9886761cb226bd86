// The files of corpora/invalid in large numbers are judged by integers of any size: fixed width declines
// them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "build.hpp"
#include "flatdt/checker/errors.hpp"
#include "geometry.hpp"

namespace flatdt::checker::test {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

enum class Width { fixed, fixed_points_only, any };

/// Of the numbers with which check() would work, all stages allowed.   Requires: group and subgroup are
/// admissible.
Width width_of(const Instance& instance, const Triangulation& triangulation) {
  const Group group =
      make_group(std::get<Crystal>(close_group(instance.dimension, instance.generators, &instance.metric)));
  ElementTable table(group);
  const auto subgroup =
      std::get<Subgroup>(Subgroup::make(group, triangulation.subgroup ? &*triangulation.subgroup : nullptr));
  std::vector<ElementId> elements;
  for (std::size_t k = 0; k < triangulation.elements.size(); ++k) {
    elements.push_back(table.intern(group.locate(triangulation.element(k)).value()));
  }
  const Orbits orbits = make_orbits(instance, table);
  const Complex complex = make_complex(triangulation, elements, orbits, subgroup, table);
  const Geometry geometry(complex, orbits, table, instance.metric);
  if (geometry.fixed()) return Width::fixed;
  return orbits.fixed ? Width::fixed_points_only : Width::any;
}

// Elements of four limbs each; those with small shifts are not counted.
TEST(LargeNumbers, OfElementsAreLimitedTogether) {
  const Instance instance = read_instance("flatdt-instance 1 dimension 2 manifold torus points 1 0 0\n");
  const Group group =
      make_group(std::get<Crystal>(close_group(instance.dimension, instance.generators, &instance.metric)));
  ElementTable table(group, 8);
  const auto shifted = [](long x) {
    Element element;
    element.shift[0] = Integer(x) << 250;
    return element;
  };
  const ElementId first = table.intern(shifted(1));
  table.intern(shifted(2));
  EXPECT_EQ(table.intern(shifted(1)), first);
  for (long x = 1; x <= 100; ++x) {
    Element element;
    element.shift[0] = x;
    table.intern(element);
  }
  EXPECT_THROW(table.intern(shifted(3)), ResourceLimit);
}

// For each geometric condition: in the plane and in space, and in manifolds whose groups are more than a
// lattice.
TEST(LargeNumbers, AreDeclinedByFixedWidthInFilesOfEachGeometricCondition) {
  std::set<Width> metrics;
  for (const char* condition :
       {"vertices.complete", "cells.nondegenerate", "facets.opposite", "volume.exact", "delaunay.empty"}) {
    std::set<int> dimensions;
    bool cosets = false;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(FLATDT_CORPORA) / "invalid" / condition)) {
      if (entry.path().extension() != ".triangulation") continue;
      const std::string name = entry.path().stem().string();
      std::filesystem::path instance_path = entry.path();
      const Instance instance = read_instance(contents(instance_path.replace_extension("instance")));
      const Triangulation triangulation = read_triangulation(contents(entry.path()), instance);
      const Width width = width_of(instance, triangulation);
      if (name.ends_with("-far") || name.ends_with("-apart") || name.ends_with("-coprime")) {
        EXPECT_EQ(width, Width::any) << condition << '/' << name;
      }
      if (name.find("metric") != std::string::npos) metrics.insert(width);
      if (width != Width::any) continue;
      dimensions.insert(instance.dimension);
      cosets = cosets || instance.claim.value_or("") == "klein-bottle";
    }
    EXPECT_EQ(dimensions, (std::set<int>{2, 3})) << condition;
    EXPECT_TRUE(cosets) << condition;
  }
  EXPECT_TRUE(metrics.contains(Width::fixed_points_only));  // too wide for the metric alone
}

}  // namespace
}  // namespace flatdt::checker::test
