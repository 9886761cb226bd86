/// The action of a torsion-free crystallographic group on E^d: membership and canonical points of orbits.
/// Uses the group analysis of ref, none of the checker's.
#pragma once

#include <vector>

#include "flatdt/ref/instance.hpp"

namespace flatdt::edits {

class CrystalGroup {
 public:
  /// Errors: ref::InvalidInput if the generators do not generate a torsion-free Bieberbach group of
  /// isometries.
  CrystalGroup(const ref::Matrix& gram, const std::vector<ref::Isometry>& generators);

  /// A point and the element that takes it to the canonical point of its orbit. Since the group acts freely,
  /// the element is unique.
  struct Canonical {
    ref::Vector point;
    ref::Isometry mover;
  };
  [[nodiscard]] Canonical canonical(const ref::Vector& x) const;

  [[nodiscard]] bool contains(const ref::Isometry& g) const;
  /// Every generator of it is in this group and conversely.
  [[nodiscard]] bool same_as(const CrystalGroup& other) const;

  /// [this : subgroup]. Requires: it is a subgroup.
  [[nodiscard]] std::size_t index_of(const CrystalGroup& subgroup) const;
  /// One element f of each right coset K f of a subgroup K, the identity first.  Cost: O(index^2)
  /// memberships.
  [[nodiscard]] std::vector<ref::Isometry> right_cosets(const CrystalGroup& subgroup) const;

  [[nodiscard]] const std::vector<ref::Isometry>& generators() const { return generators_; }
  /// One element for each linear part, the identity first.
  [[nodiscard]] const std::vector<ref::Isometry>& cosets() const { return cosets_; }
  /// A basis of the translation lattice: columns of a lower triangular matrix.
  [[nodiscard]] const ref::Matrix& lattice() const { return lattice_; }
  /// A random element; its translation is up to `reach` lattice vectors in each direction. `number` yields
  /// integers of [0, bound).
  template <class Random>
  [[nodiscard]] ref::Isometry element(Random& random, int reach) const {
    const ref::Isometry& coset = random.choice(cosets_);
    return translation(random, reach) * coset;
  }
  template <class Random>
  [[nodiscard]] ref::Isometry translation(Random& random, int reach) const {
    ref::Vector v(lattice_.dimension());
    for (int j = 0; j < v.dimension(); ++j)
      v = v + ref::Rational(random.between(-reach, reach)) * lattice_.column(j);
    return ref::Isometry::translate(v);
  }

 private:
  [[nodiscard]] ref::Vector reduced(ref::Vector x) const;

  std::vector<ref::Isometry> generators_;
  std::vector<ref::Isometry> cosets_;
  ref::Matrix lattice_;
};

}  // namespace flatdt::edits
