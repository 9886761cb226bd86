/// Lattice reduction: Lagrange's in the plane; in space the greedy algorithm, then at most one step of
/// Selling's.
/// Source: [NguyenStehle09] for the greedy algorithm; [Selling1874], [ConwaySloane92] for obtuse superbases.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"
#include "lattice_descent.hpp"

namespace flatdt::ref {
namespace {

/// Makes |u| <= |v| and 2 |<u,v>| <= |u|^2 (Lagrange, Gauss).
/// Complexity: O(log(|v|/shortest)) steps [Lagarias80]; a last tie <u,v> = |u|^2/2 is sent to
/// -|u|^2/2, where the quotient is 0, so it cannot repeat.
void lagrange_reduce(const Matrix& gram, Vector& u, Vector& v) {
  for (;;) {
    if (squared_length(gram, v) < squared_length(gram, u)) std::swap(u, v);
    const Integer multiple = round_half_up(inner_product(gram, u, v) / squared_length(gram, u));
    if (multiple.is_zero()) return;
    v = v - Rational(multiple) * u;
  }
}

/// w - s for a vector s of the lattice of u and v closest to w. Requires: u, v reduced by lagrange_reduce.
Vector reduce_by_plane(const Matrix& gram, const Vector& u, const Vector& v, const Vector& w) {
  const Vector obtuse_v = inner_product(gram, u, v).sign() == Sign::positive ? -v : v;
  Matrix plane(2);
  plane(0, 0) = squared_length(gram, u);
  plane(0, 1) = plane(1, 0) = inner_product(gram, u, obtuse_v);
  plane(1, 1) = squared_length(gram, obtuse_v);
  Vector products(2);
  products[0] = inner_product(gram, u, w);
  products[1] = inner_product(gram, obtuse_v, w);
  const Vector coordinates = plane.inverse() * products;
  const Vector start = w - Rational(floor(coordinates[0])) * u - Rational(floor(coordinates[1])) * obtuse_v;
  return descend(gram, proper_subset_sums({u, obtuse_v, -(u + obtuse_v)}), start);
}

/// Makes |u| <= |v| <= |w| and 2 |<x,y>| <= |x|^2 for every two of them.
/// Complexity: O(log(|w|/shortest)) rounds [NguyenStehle09]; pairwise reduction alone, and
/// Selling's algorithm from an arbitrary basis, have no such bound: the latter takes 10^300 steps on entries
/// of 10^600.
void greedy_reduce(const Matrix& gram, Vector& u, Vector& v, Vector& w) {
  for (;;) {
    lagrange_reduce(gram, u, v);
    w = reduce_by_plane(gram, u, v, w);
    if (squared_length(gram, w) >= squared_length(gram, v)) return;
    std::swap(v, w);
  }
}

bool is_obtuse(const Matrix& gram, const std::vector<Vector>& vectors) {
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (inner_product(gram, vectors[i], vectors[j]).sign() == Sign::positive) return false;
  return true;
}

/// An obtuse superbase from a basis with 2 |<b_i,b_j>| <= min(|b_i|^2, |b_j|^2).
/// Proof. If signs make all products <= 0, b_0 = -(b_1+b_2+b_3) will do: <b_0,b_i> = -(|b_i|^2 + two products
/// of at most |b_i|^2/2). Otherwise signs make all products positive. Let <b_i,b_j> be the least, b_k the
/// third, and take -b_i, b_j, b_i - b_k, b_k - b_j (Selling's step for b_i, b_j after negating b_k).
/// Products:
/// -<b_i,b_j>; <b_i,b_k> - |b_i|^2; <b_i,b_j> - <b_i,b_k>; <b_i,b_j> - <b_j,b_k>; <b_j,b_k> - |b_j|^2 and
/// <b_i,b_k> + <b_j,b_k> - <b_i,b_j> - |b_k|^2. All are <= 0.
std::vector<Vector> obtuse_superbase(const Matrix& gram, const std::array<Vector, 3>& basis) {
  for (unsigned signs = 0; signs < 4; ++signs) {
    const std::vector<Vector> b = {basis[0], (signs & 1U) != 0 ? -basis[1] : basis[1],
                                   (signs & 2U) != 0 ? -basis[2] : basis[2]};
    const std::array<Rational, 3> opposite = {
        inner_product(gram, b[1], b[2]), inner_product(gram, b[2], b[0]), inner_product(gram, b[0], b[1])};
    if (is_obtuse(gram, b)) return {b[0], b[1], b[2], -(b[0] + b[1] + b[2])};
    const auto least = std::min_element(opposite.begin(), opposite.end());
    if (least->sign() != Sign::positive) continue;
    const auto k = static_cast<std::size_t>(least - opposite.begin());
    const Vector &bi = b[(k + 1) % 3], &bj = b[(k + 2) % 3], &bk = b[k];
    return {-bi, bj, bi - bk, bk - bj};
  }
  throw InternalError("the signs of a basis make its products all positive or all nonpositive");
}

/// The same Gram matrix times the least positive integer that makes it integral: keeps the arithmetic free of
/// fractions.
Matrix cleared_of_denominators(const Matrix& gram) {
  Integer scale = 1;
  for (int i = 0; i < gram.dimension(); ++i)
    for (int j = 0; j < gram.dimension(); ++j) scale = lcm(scale, gram(i, j).denominator());
  return Rational(scale) * gram;
}

/// Columns ordered by length with an obtuse superbase, minus their sum the longest of it.
bool is_reduced(const Matrix& gram) {
  const int d = gram.dimension();
  Rational last;
  for (int i = 0; i < d; ++i) {
    Rational opposite;  // minus the product of column i with minus the sum of all
    for (int j = 0; j < d; ++j) {
      if (j != i && gram(i, j).sign() == Sign::positive) return false;
      opposite += gram(i, j);
    }
    if (opposite.sign() == Sign::negative || (i > 0 && gram(i, i) < gram(i - 1, i - 1))) return false;
    last += opposite;
  }
  return gram(d - 1, d - 1) <= last;
}

}  // namespace

ReducedBasis reduce_basis(const Matrix& gram) {
  const int d = gram.dimension();
  ensure((d == 2 || d == 3) && is_positive_definite(gram), "a Gram matrix to reduce is positive definite");
  // Frames are reduced: this spares most calls nearly all of their work.
  if (is_reduced(gram)) return {Matrix::identity(d), gram};
  const Matrix integral = cleared_of_denominators(gram);
  const Matrix unit = Matrix::identity(d);
  std::vector<Vector> reduced;
  if (d == 2) {
    Vector u = unit.column(0), v = unit.column(1);
    lagrange_reduce(integral, u, v);
    if (inner_product(integral, u, v).sign() == Sign::positive) v = -v;
    reduced = {u, v};
  } else {
    std::array<Vector, 3> basis = {unit.column(0), unit.column(1), unit.column(2)};
    greedy_reduce(integral, basis[0], basis[1], basis[2]);
    reduced = obtuse_superbase(integral, basis);
    ensure(is_obtuse(integral, reduced), "a pairwise reduced basis gives an obtuse superbase");
    std::stable_sort(reduced.begin(), reduced.end(), [&](const Vector& a, const Vector& b) {
      return squared_length(integral, a) < squared_length(integral, b);
    });
  }
  ReducedBasis result{Matrix(d), Matrix(d)};
  for (int j = 0; j < d; ++j) result.transform.set_column(j, reduced[static_cast<std::size_t>(j)]);
  result.gram = result.transform.transpose() * gram * result.transform;
  return result;
}

}  // namespace flatdt::ref
