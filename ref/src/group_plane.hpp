/// A lattice of rank 2 in working coordinates, seen in its own plane.
#pragma once

#include "flatdt/ref/linear.hpp"

namespace flatdt::ref {

class PlaneLattice {
 public:
  /// The lattice with basis (p, q); `gram` is that of the working coordinates.
  PlaneLattice(const Matrix& gram, Vector p, Vector q);

  /// Gram matrix of (p, q).
  [[nodiscard]] const Matrix& gram() const { return gram_; }
  /// k with at(k) = v. Requires: v in the plane (else: of its orthogonal projection).
  [[nodiscard]] Vector coordinates(const Vector& v) const;
  /// k_0 p + k_1 q.
  [[nodiscard]] Vector at(const Vector& k) const { return k[0] * p_ + k[1] * q_; }
  /// The lattice vector closest to v; of several, the least in coordinates.
  [[nodiscard]] Vector closest_to(const Vector& v) const;
  /// The shortest w, up to sign, for which (w, v) is a basis. Requires: v primitive in the lattice.
  [[nodiscard]] Vector shortest_completion(const Vector& v) const;

 private:
  Matrix ambient_;
  Vector p_, q_;
  Matrix gram_{2};
};

}  // namespace flatdt::ref
