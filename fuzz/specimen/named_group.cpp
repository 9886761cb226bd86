#include "named_group.hpp"

#include <algorithm>

namespace flatdt::fuzz {
namespace {

ref::Isometry reduced(ref::Isometry g) {
  for (int i = 0; i < g.dimension(); ++i)
    g.translation[i] = g.translation[i] - ref::Rational(floor(g.translation[i]));
  return g;
}

/// Ends because modulo the translations of Z^d the group is finite.
std::vector<ref::Isometry> cosets_of(const std::vector<ref::Isometry>& generators, int dimension) {
  std::vector<ref::Isometry> cosets = {ref::Isometry::identity(dimension)};
  for (std::size_t k = 0; k < cosets.size(); ++k) {
    for (const ref::Isometry& g : generators) {
      const ref::Isometry product = reduced(g * cosets[k]);
      const auto same_part = [&](const ref::Isometry& c) { return c.linear == product.linear; };
      if (std::none_of(cosets.begin(), cosets.end(), same_part)) cosets.push_back(product);
    }
  }
  return cosets;
}

}  // namespace

const std::vector<NamedGroup>& named_groups() {
  static const std::vector<NamedGroup> groups = [] {
    std::vector<NamedGroup> list;
    for (const ref::CatalogueEntry& entry : ref::catalogue()) {
      list.push_back({entry.name, &entry, entry.generators, cosets_of(entry.generators, entry.dimension)});
      if (entry.mirror_aliases.empty()) continue;
      list.push_back({entry.mirror_aliases.front(), &entry, entry.mirror_image_generators,
                      cosets_of(entry.mirror_image_generators, entry.dimension)});
    }
    return list;
  }();
  return groups;
}

}  // namespace flatdt::fuzz
