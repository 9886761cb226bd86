/// Which of the twelve: (dimension, orientable, holonomy, H1) separates them.
#include <algorithm>

#include "flatdt/ref/errors.hpp"
#include "group_parts.hpp"

namespace flatdt::ref {

std::string holonomy_name(const WorkingGroup& group) {
  const std::size_t order = group.cosets.size();
  int largest = 1;
  for (const Isometry& coset : group.cosets) largest = std::max(largest, cyclic_sum(coset.linear).order);
  if (order == 1) return "1";
  if (static_cast<std::size_t>(largest) == order) return "Z" + std::to_string(order);
  ensure(order == 4, "the holonomy of a closed flat manifold is cyclic or Z2xZ2 in dimension 2 and 3");
  return "Z2xZ2";
}

bool is_orientable(const std::vector<Isometry>& cosets) {
  return std::all_of(cosets.begin(), cosets.end(),
                     [](const Isometry& g) { return g.linear.determinant().sign() == Sign::positive; });
}

const CatalogueEntry& recognise(const WorkingGroup& group) {
  const std::string holonomy = holonomy_name(group);
  const bool orientable = is_orientable(group.cosets);
  const Homology h1 = first_homology(group);
  for (const CatalogueEntry& entry : catalogue())
    if (entry.dimension == group.gram.dimension() && entry.orientable == orientable &&
        entry.holonomy == holonomy && entry.h1 == h1)
      return entry;
  throw InternalError("every closed flat manifold of dimension 2 or 3 is in the catalogue");
}

}  // namespace flatdt::ref
