/// Linear equations over the integers, by the Smith normal form left * a * right = diagonal: with x = right
/// y, a x = r becomes diagonal y = left r.
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"
#include "group_parts.hpp"

namespace flatdt::ref {
namespace {

std::size_t size_of(int dimension) {
  return static_cast<std::size_t>(dimension);
}

/// The matrices below one another.
IntegerMatrix stacked(const std::vector<Matrix>& blocks) {
  IntegerMatrix rows;
  for (const Matrix& block : blocks) {
    for (int i = 0; i < block.dimension(); ++i) {
      std::vector<Integer> row;
      for (int j = 0; j < block.dimension(); ++j) {
        ensure(block(i, j).is_integer(), "an equation over the integers has integral coefficients");
        row.push_back(block(i, j).numerator());
      }
      rows.push_back(row);
    }
  }
  return rows;
}

Rational dot(const std::vector<Integer>& row, const std::vector<Rational>& v) {
  Rational sum;
  for (std::size_t j = 0; j < row.size(); ++j) sum += Rational(row[j]) * v[j];
  return sum;
}

Vector times(const IntegerMatrix& right, const std::vector<Rational>& y) {
  Vector x(static_cast<int>(y.size()));
  for (std::size_t i = 0; i < y.size(); ++i) x[static_cast<int>(i)] = dot(right[i], y);
  return x;
}

std::vector<Rational> joined(const std::vector<Vector>& parts) {
  std::vector<Rational> all;
  for (const Vector& part : parts)
    for (int i = 0; i < part.dimension(); ++i) all.push_back(part[i]);
  return all;
}

}  // namespace

std::vector<Vector> kernel_basis(const Matrix& m) {
  const SmithForm smith = smith_normal_form(stacked({m}));
  const int d = m.dimension();
  std::vector<Vector> basis;
  // The kernel of the diagonal is spanned by the unit vectors at its zeros.
  for (int j = 0; j < d; ++j) {
    if (!smith.diagonal[size_of(j)][size_of(j)].is_zero()) continue;
    Vector v(d);
    for (int i = 0; i < d; ++i) v[i] = smith.right[size_of(i)][size_of(j)];
    basis.push_back(v);
  }
  return basis;
}

std::optional<Vector> solve_integral(const Matrix& m, const Vector& rhs) {
  const SmithForm smith = smith_normal_form(stacked({m}));
  const std::vector<Rational> r = joined({rhs});
  std::vector<Rational> y(r.size());
  for (std::size_t i = 0; i < r.size(); ++i) {
    const Rational value = dot(smith.left[i], r);
    const Integer& divisor = smith.diagonal[i][i];
    if (!divisor.is_zero())
      y[i] = value / Rational(divisor);
    else if (!value.is_zero())
      return std::nullopt;
    if (!y[i].is_integer()) return std::nullopt;
  }
  return times(smith.right, y);
}

std::optional<Vector> solve_congruences(const std::vector<Matrix>& a, const std::vector<Vector>& r) {
  ensure(!a.empty() && a.size() == r.size(), "each congruence has two sides");
  const SmithForm smith = smith_normal_form(stacked(a));
  const std::vector<Rational> right_side = joined(r);
  // left is unimodular, so r + Z^n becomes left r + Z^n: a row of zeros needs an integer there, any other row
  // has the solution value / divisor.
  std::vector<Rational> y(size_of(a[0].dimension()));
  for (std::size_t i = 0; i < right_side.size(); ++i) {
    const Rational value = dot(smith.left[i], right_side);
    const bool is_zero_row = i >= y.size() || smith.diagonal[i][i].is_zero();
    if (!is_zero_row)
      y[i] = value / Rational(smith.diagonal[i][i]);
    else if (!value.is_integer())
      return std::nullopt;
  }
  return times(smith.right, y);
}

}  // namespace flatdt::ref
