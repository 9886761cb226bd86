/// All point sets on a grid of a manifold, modulo symmetry.
/// A point set is a set of G-orbits of grid points; two are the same if an isometry of the canonical metric
/// that normalises G and maps the grid to itself takes one to the other.
/// Invariants: integers only; coordinates are multiples of 1/K, K a common denominator of grid and group.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "flatdt/ref/instance.hpp"

namespace flatdt::property_tests {

class SmallWorld {
 public:
  /// The points with coordinates in (1/k_0)Z x (1/k_1)Z x (1/k_2)Z of a manifold of the catalogue (k_2 = 1 in
  /// the plane).
  /// Requires: the group maps this grid to itself (Violation otherwise).
  SmallWorld(const std::string& manifold, const std::array<long, 3>& divisions);

  /// Number of G-orbits of grid points: k_0 k_1 k_2 / |holonomy|, as G acts freely.
  [[nodiscard]] std::size_t orbits() const { return representatives_.size(); }
  /// Number of permutations of the orbits that the symmetries make.
  [[nodiscard]] std::size_t symmetries() const { return permutations_.size(); }

  using PointSet = std::vector<std::uint16_t>;  // numbers of orbits, ascending
  /// One point set of each class of `size` orbits, by enumeration of all of them.
  /// Requires: 1 <= size <= 4. Cost: C(orbits, size) bits, and a step for each class and symmetry.
  [[nodiscard]] std::vector<PointSet> point_sets(std::size_t size) const;
  /// The number of classes by the lemma of Burnside: the mean number of sets that a symmetry fixes, from its
  /// cycles.
  [[nodiscard]] std::size_t count_by_burnside(std::size_t size) const;

  /// The instance with these points, the name alone and the canonical metric.
  [[nodiscard]] ref::Instance instance(const PointSet& points) const;

 private:
  using IntVector = std::array<long, 3>;
  using IntMatrix = std::array<IntVector, 3>;
  struct IntMap {
    IntMatrix linear;
    IntVector translation;  // times K
  };
  [[nodiscard]] std::size_t code(const IntVector& x) const;
  [[nodiscard]] IntVector grid_point(std::size_t code) const;
  [[nodiscard]] IntVector apply(const IntMap& map, const IntVector& x) const;
  [[nodiscard]] bool maps_grid_to_itself(const IntMap& map) const;
  [[nodiscard]] bool normalises_group(const IntMap& map) const;
  [[nodiscard]] std::vector<IntMatrix> linear_isometries() const;
  void number_orbits();
  void find_symmetries();

  std::string manifold_;
  int dimension_;
  IntVector divisions_;
  long unit_ = 1;  // K
  std::vector<IntMap> cosets_;
  std::vector<std::size_t> representatives_;  // grid codes, ascending
  std::vector<std::uint16_t> orbit_of_;       // by grid code
  std::vector<std::vector<std::uint16_t>> permutations_;
};

}  // namespace flatdt::property_tests
