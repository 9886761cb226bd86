/// Enumeration of short lattice vectors, line by line in the reduced basis.
/// Source: [FinckePohst85]; differs: the two outer coordinates from the dual basis, the last by walking
/// outwards.
#include <vector>

#include "flatdt/ref/lattice.hpp"
#include "lattice_root.hpp"

namespace flatdt::ref {

std::vector<Vector> short_vectors(const Matrix& gram, const Rational& bound) {
  std::vector<Vector> found;
  if (bound.sign() != Sign::positive) return found;
  const int d = gram.dimension(), last = d - 1;
  const ReducedBasis reduced = reduce_basis(gram);
  // |x_i| = |<x, e_i*>| <= |x| |e_i*|, e_i* the dual basis, whose Gram matrix is the inverse. In a reduced
  // basis the box is larger than the ball by a constant factor only.
  const Matrix dual = reduced.gram.inverse();
  const auto range = [&](int i) { return floor_sqrt(bound * dual(i, i)); };
  const auto walk = [&](Vector x, int step) {
    for (; squared_length(reduced.gram, x) <= bound; x[last] += step)
      if (!x.is_zero()) found.push_back(reduced.transform * x);
  };
  const Integer range0 = range(0), range1 = d == 3 ? range(1) : Integer(0);
  for (Integer x0 = -range0; x0 <= range0; x0 += 1) {
    for (Integer x1 = -range1; x1 <= range1; x1 += 1) {
      Vector x(d);
      x[0] = x0;
      if (d == 3) x[1] = x1;
      // |x|^2 is convex along the line, least at -<x, e_last> / |e_last|^2: outwards from there, both ways.
      const Vector gx = reduced.gram * x;
      x[last] = floor(-gx[last] / reduced.gram(last, last));
      walk(x, -1);
      x[last] += 1;
      walk(x, 1);
    }
  }
  return found;
}

}  // namespace flatdt::ref
