/// The catalogue of the twelve closed flat manifolds of dimension 2 and 3, in lattice coordinates.
/// Conventions: the translation lattice of an entry is exactly Z^d; delta^2 is the square of the least
/// distance by which an element other than the identity moves a point.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flatdt/ref/isometry.hpp"

namespace flatdt::ref {

/// First homology: Z^betti plus cyclic groups whose orders divide one another.
struct Homology {
  int betti = 0;
  std::vector<long> torsion;
  friend bool operator==(const Homology&, const Homology&) = default;
};

struct CatalogueEntry {
  std::string name;
  std::vector<std::string> aliases;
  int dimension;
  std::vector<std::string> space_groups;
  std::vector<Isometry> generators;
  /// Empty unless the group has a mirror image that is not conjugate to it by an orientation-preserving map.
  std::vector<Isometry> mirror_image_generators;
  std::vector<std::string> mirror_aliases;      // names that mean mirror_image_generators: P32, P43, P65
  std::vector<Isometry> coset_representatives;  // of the translation lattice; the identity first
  Matrix canonical_gram;
  std::string metric_cone;  // e.g. "A 0 / 0 B with A>0, B>0"
  std::string holonomy;     // e.g. "Z2xZ2"
  int holonomy_order;
  bool orientable;
  Homology h1;
  std::string delta_squared_formula;
  Rational canonical_delta_squared;
  bool left_orderable;
  /// Coordinates, counted from 0, in which R^-1 t is compared (DESIGN: ties). For the didicosm: those of its
  /// index-2 dicosm subgroup.
  std::vector<int> left_order_coordinates;
};

/// The twelve entries in the order of the documentation.
const std::vector<CatalogueEntry>& catalogue();
/// The entry with this name or alias (case-sensitive), or nothing.
const CatalogueEntry* find_entry(std::string_view name_or_alias);
/// The generators that a name without a `generators` section means: the mirror image for P32, P43, P65.
const std::vector<Isometry>& generators_of(const CatalogueEntry& entry, std::string_view name_or_alias);

}  // namespace flatdt::ref
