/// Subgroups of finite index, normal or not, and the instances that say the same with them.
#pragma once

#include "specimen.hpp"

namespace flatdt::property_tests {

/// The specimen's points for a subgroup H of its group G: instance coordinates as the specimen's, for each
/// point r p, r in representatives of the right cosets Hr.
struct SubgroupInstance {
  ref::Instance instance;
  std::size_t index = 1;                       // [G:H]
  std::vector<ref::Isometry> representatives;  // of the right cosets, instance coordinates
};

/// A random subgroup with 1 < [G:H] <= max_index: multiples of the lattice vectors with some elements of the
/// group.
/// Requires: max_index >= 2. Every catalogue group has a subgroup of index 2 or 3.
SubgroupInstance draw_subgroup(const testing::Specimen& s, std::size_t max_index, std::uint64_t seed);

/// The subgroup that the elements (catalogue coordinates) generate.
/// Requires: finite index at most 1000.
SubgroupInstance subgroup_instance(const testing::Specimen& s, const std::vector<ref::Isometry>& generators);

}  // namespace flatdt::property_tests
