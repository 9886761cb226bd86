/// An instance: a group, a metric and points, as written in a `flatdt-instance 1` file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flatdt/ref/isometry.hpp"

namespace flatdt::ref {

/// Lines of the file at which sections stand, 0 where a section is absent: for messages only.
struct SectionLines {
  int manifold = 0;
  int generators = 0;
  int metric = 0;
};

struct Instance {
  int dimension = 0;
  /// The claimed name exactly as in the file, if any.
  std::optional<std::string> name;
  /// The generators as written; without a `generators` section the catalogue's generators of the name.
  std::vector<Isometry> generators;
  /// False if the generators come from the name alone.
  bool generators_given = false;
  /// Gram matrix of the coordinates' basis. Squared lengths are v^T gram v ("Gram units").
  Matrix gram{0};
  std::vector<Vector> points;
  SectionLines lines;
};

}  // namespace flatdt::ref
