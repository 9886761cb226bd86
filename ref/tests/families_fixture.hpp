/// Shared by the tests of families: the manifold under test by its name, and equivalence of points.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "flatdt/ref/families.hpp"

namespace flatdt::ref {

/// g x - y is a lattice vector for one of the coset representatives. Requires: the lattice is Z^d.
inline bool equivalent(const std::vector<Isometry>& cosets, const Vector& x, const Vector& y) {
  return std::any_of(cosets.begin(), cosets.end(),
                     [&](const Isometry& g) { return (g * x - y).is_integral(); });
}

class EveryManifold : public testing::TestWithParam<std::string> {
 protected:
  const CatalogueEntry& entry() const { return *find_entry(GetParam()); }
  Instance make(const std::string& family, long n, std::uint64_t seed = 1,
                const std::string& metric = "canonical") const {
    return generate(entry(), entry().name, family, n, seed, metric);
  }
  const std::vector<Isometry>& cosets() const { return entry().coset_representatives; }
  bool has(Sign determinant) const {
    return std::any_of(cosets().begin(), cosets().end(), [&](const Isometry& g) {
      return !g.linear.is_identity() && g.linear.determinant().sign() == determinant;
    });
  }
};

inline std::vector<std::string> manifold_names() {
  std::vector<std::string> list;
  for (const CatalogueEntry& entry : catalogue()) list.push_back(entry.name);
  return list;
}

inline std::string test_name(const testing::TestParamInfo<std::string>& tested) {
  std::string name = tested.param;
  std::erase(name, '-');
  return name;
}

}  // namespace flatdt::ref
