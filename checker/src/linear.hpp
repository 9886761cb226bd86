// Linear algebra in dimension d = 2 or 3 over an exact ring.
#pragma once

#include <cstddef>
#include <string>

#include "flatdt/checker/exact.hpp"

namespace flatdt::checker {

template <class T>
[[nodiscard]] Mat<T> identity(int d) {
  Mat<T> m;
  for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) m[i][i] = 1;
  return m;
}

/// A x.
template <class T, class U>
[[nodiscard]] Vec<U> multiply(int d, const Mat<T>& a, const Vec<U>& x) {
  Vec<U> y;
  const auto n = static_cast<std::size_t>(d);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) y[i] += a[i][k] * x[k];
  }
  return y;
}

/// A B.
template <class T>
[[nodiscard]] Mat<T> multiply(int d, const Mat<T>& a, const Mat<T>& b) {
  Mat<T> c;
  const auto n = static_cast<std::size_t>(d);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}

template <class T>
[[nodiscard]] Mat<T> transpose(const Mat<T>& a) {
  Mat<T> b;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) b[j][i] = a[i][j];
  }
  return b;
}

template <class T>
[[nodiscard]] Vec<T> add(const Vec<T>& a, const Vec<T>& b) {
  return {T(a[0] + b[0]), T(a[1] + b[1]), T(a[2] + b[2])};
}

template <class T>
[[nodiscard]] Vec<T> subtract(const Vec<T>& a, const Vec<T>& b) {
  return {T(a[0] - b[0]), T(a[1] - b[1]), T(a[2] - b[2])};
}

/// Determinant of the leading d x d block, d = 1, 2 or 3.
template <class T>
[[nodiscard]] T determinant(int d, const Mat<T>& a) {
  if (d == 1) return a[0][0];
  T minor = a[0][0] * a[1][1] - a[0][1] * a[1][0];
  if (d == 2) return minor;
  return a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]) -
         a[1][2] * (a[0][0] * a[2][1] - a[0][1] * a[2][0]) + a[2][2] * minor;
}

/// Inverse by cofactors. Requires: determinant not 0.
[[nodiscard]] Mat<Rational> inverse(int d, const Mat<Rational>& a);

/// g h: first h, then g.
[[nodiscard]] Seitz compose(int d, const Seitz& g, const Seitz& h);
/// g x.
[[nodiscard]] Vec<Rational> apply(int d, const Seitz& g, const Vec<Rational>& x);
/// The map of g in the coordinates y with x = basis y.
[[nodiscard]] Seitz change_basis(int d, const Seitz& g, const Mat<Rational>& basis,
                                 const Mat<Rational>& basis_inverse);

/// v^T gram v.
[[nodiscard]] Rational squared_norm(int d, const Mat<Rational>& gram, const Vec<Rational>& v);

/// "(1/2,0)" and "[1,0|1/2;0,1|0]".
[[nodiscard]] std::string to_string(int d, const Vec<Rational>& x);
[[nodiscard]] std::string to_string(int d, const Seitz& g);

}  // namespace flatdt::checker
