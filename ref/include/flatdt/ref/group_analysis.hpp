/// What DESIGN asks of a group given by generators: is it a torsion-free Bieberbach group, which of the
/// twelve is it, and the frame in which the algorithms work on it.
#pragma once

#include <array>
#include <vector>

#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance.hpp"

namespace flatdt::ref {

/// The group in frame coordinates: x_instance = basis * x_frame + origin, where the columns of basis are a
/// reduced basis of the translation lattice. In the frame the lattice is Z^d, linear parts are integral and
/// the translations of the coset representatives are multiples of 1/translation_denominator in [0,1).
struct Frame {
  int dimension = 0;
  Matrix basis{0};
  Vector origin{0};
  /// Gram matrix of the reduced basis: squared lengths in the instance's Gram units.
  Matrix gram{0};
  /// Right and left cosets of the translation lattice coincide; representatives in frame coordinates, the
  /// identity first, then by linear part as sorted in catalogue coordinates.
  std::vector<Isometry> cosets;
  int translation_denominator = 1;
  /// x_catalogue = to_catalogue * x_frame: unimodular. In catalogue coordinates the group is exactly that of
  /// the entry or, if `mirrored`, its mirror_image_generators.
  Matrix to_catalogue{0};
  const CatalogueEntry* entry = nullptr;
  bool mirrored = false;
  Rational delta_squared;
};

/// The result of analyse(). All in instance coordinates unless said otherwise.
struct GroupAnalysis {
  const CatalogueEntry* entry;
  int holonomy_order;
  bool orientable;
  Homology h1;
  /// Hermite normal form of the translation lattice, columns.
  Matrix lattice;
  /// One element for each linear part, the identity first, translations reduced by the lattice.
  std::vector<Isometry> cosets;
  Rational volume_squared;  // of the manifold: det(lattice)^2 det(gram) / holonomy_order^2
  Frame frame;
};

/// The group does not act freely. element() is in the group, is not the identity, and fixes point(); both are
/// in instance coordinates.
class FixedPointError : public InvalidInput {
 public:
  FixedPointError(const Isometry& element, const Vector& point);
  [[nodiscard]] const Isometry& element() const { return element_; }
  [[nodiscard]] const Vector& point() const { return point_; }

 private:
  Isometry element_;
  Vector point_;
};

/// Analyses the group of an instance.
/// Requires: instance.gram symmetric. Errors: InvalidInput naming the element: metric not positive definite
/// or not invariant under a generator, point group too large (a 13th or 49th linear part), lattice of rank <
/// d, an element of finite order (FixedPointError), a wrong name, checked in this order. LimitReached for
/// denominators beyond HermiteBasis::kMaxBits. Laws: the result depends on the group and the metric only, not
/// on the generators given; if the group is literally that of the entry (or its mirror image), catalogue
/// coordinates are instance coordinates. Complexity: O(generators * holonomy order) products. Source:
/// Bieberbach's theorem (Theorem 5 of the paper); names follow from (dimension, orientable, holonomy, H1).
GroupAnalysis analyse(const Instance& instance);

}  // namespace flatdt::ref
