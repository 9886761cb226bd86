/// Random lattices for the tests: a fixed seed gives fixed lattices on every platform.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "flatdt/ref/linear.hpp"

namespace flatdt::ref::samples {

using Random = std::mt19937_64;

/// Uniform in [low, high], both ends included.
inline int uniform(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned long>(high - low + 1));
}

/// Numerators in [-range, range] over one denominator.
inline Vector random_vector(Random& random, int d, int range, int denominator) {
  Vector v(d);
  for (int i = 0; i < d; ++i) v[i] = Rational(Integer(uniform(random, -range, range)), Integer(denominator));
  return v;
}

inline Matrix random_unimodular(Random& random, int d, int steps) {
  Matrix m = Matrix::identity(d);
  for (int k = 0; k < steps; ++k) {
    const int i = uniform(random, 0, d - 1), j = (i + uniform(random, 1, d - 1)) % d;
    m.set_column(i, m.column(i) + Rational(uniform(random, -3, 3)) * m.column(j));
  }
  return m;
}

/// A^T A for a random integral A: degenerate (orthogonal, body- or face-centred) lattices are frequent.
inline Matrix random_gram(Random& random, int d, int range) {
  for (;;) {
    Matrix a(d);
    for (int j = 0; j < d; ++j) a.set_column(j, random_vector(random, d, range, 1));
    if (!a.determinant().is_zero()) return a.transpose() * a;
  }
}

/// Row by row.
inline Matrix gram_of(int d, const std::vector<int>& entries) {
  Matrix m(d);
  for (int i = 0; i < d; ++i)
    for (int j = 0; j < d; ++j) m(i, j) = entries[static_cast<std::size_t>(i * d + j)];
  return m;
}

/// All integer vectors with coordinates in [-bound, bound].
inline std::vector<Vector> box(int d, int bound) {
  std::vector<Vector> all = {Vector(d)};
  for (int i = 0; i < d; ++i) {
    std::vector<Vector> longer;
    for (const Vector& v : all) {
      for (int x = -bound; x <= bound; ++x) {
        longer.push_back(v);
        longer.back()[i] = x;
      }
    }
    all = longer;
  }
  return all;
}

}  // namespace flatdt::ref::samples
