/// Finitely generated abelian groups from generators and relations: a simple Smith normal form.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "flatdt/checker/exact.hpp"

namespace flatdt::naive {

using checker::Integer;

/// Z^rank plus cyclic groups of the orders in `torsion`, each greater than 1 and a divisor of the next.
struct AbelianGroup {
  std::size_t rank = 0;
  std::vector<Integer> torsion;

  friend bool operator==(const AbelianGroup&, const AbelianGroup&) = default;
};

/// One relation: generator -> coefficient. Entries that are 0 may be there or not.
using Relation = std::map<std::size_t, Integer>;

/// Z^generators modulo the relations.
/// Termination: every round removes a relation or makes the least nonzero |coefficient| smaller.
[[nodiscard]] AbelianGroup quotient(std::size_t generators, std::vector<Relation> relations);

}  // namespace flatdt::naive
