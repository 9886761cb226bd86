/// Closest vectors of one lattice to many points: what depends on the lattice alone is computed once.
#pragma once

#include <vector>

#include "flatdt/ref/linear.hpp"

namespace flatdt::ref {

/// As closest_vectors of lattice.hpp.
class ClosestVectors {
 public:
  /// Any gram (reduced inside). Requires: gram positive definite.
  explicit ClosestVectors(const Matrix& gram);
  /// All lattice vectors (integer coordinates) closest to x, in lexicographic order.
  [[nodiscard]] std::vector<Vector> operator()(const Vector& x) const;

 private:
  /// A vector n that may be Voronoi-relevant, in the reduced basis.
  struct Relevant {
    Vector n;
    Vector dual;  // gram n, so that dual . x = <n,x>
    Rational squared_length;
  };
  /// <n,n> - 2 <n,x>: negative iff x - n is shorter than x.
  [[nodiscard]] static Rational change(const Relevant& relevant, const Vector& x);
  [[nodiscard]] Vector descend(Vector x) const;

  Matrix transform_;
  Matrix inverse_;
  std::vector<Relevant> relevant_;
};

}  // namespace flatdt::ref
