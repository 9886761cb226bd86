// The twelve closed flat manifolds of dimensions 2 and 3: their names, generators and invariants.
// Source: [HantzscheWendt35]; the names of [ConwayRossetti03].
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "flatdt/checker/exact.hpp"

namespace flatdt::checker {

/// One manifold. (dimension, orientable, holonomy, homology) separates all twelve.
struct Manifold {
  std::string_view name;
  std::string_view aliases;  ///< separated and surrounded by spaces
  std::string_view mirror;   ///< the aliases whose generators are the mirror images, likewise
  int dimension;
  bool orientable;
  std::string_view holonomy;    ///< as holonomy_name()
  std::string_view homology;    ///< as to_string(AbelianGroup)
  std::string_view generators;  ///< Seitz matrices in lattice coordinates, as in an instance file
  std::string_view mirrored;    ///< generators of the mirror image where the aliases distinguish it
  bool hexagonal;               ///< canonical Gram matrix 1 -1/2 0 1 0 1; else the identity
};

/// The manifold with a name or alias, or null.
[[nodiscard]] const Manifold* find_manifold(std::string_view name);

/// The name of the manifold with these invariants, if there is one.
[[nodiscard]] std::optional<std::string_view> recognise(int dimension, bool orientable,
                                                        std::string_view holonomy, std::string_view homology);

/// The catalogue's generators that `name` (a name or alias of `manifold`) stands for.
[[nodiscard]] std::vector<Seitz> catalogue_generators(const Manifold& manifold, std::string_view name);

/// The catalogue's canonical Gram matrix.
[[nodiscard]] Mat<Rational> canonical_metric(const Manifold& manifold);

}  // namespace flatdt::checker
