/// The groups that a specimen can name: the twelve manifolds and the mirror images of three of them.
#pragma once

#include <string>
#include <vector>

#include "flatdt/ref/catalogue.hpp"

namespace flatdt::fuzz {

/// In catalogue coordinates: the translation lattice is Z^d.
struct NamedGroup {
  std::string name;
  const ref::CatalogueEntry* entry;
  std::vector<ref::Isometry> generators;
  /// One element for each linear part, the identity first, translations in [0,1).
  std::vector<ref::Isometry> cosets;
};

/// The fifteen groups, those of the plane first.
const std::vector<NamedGroup>& named_groups();

}  // namespace flatdt::fuzz
