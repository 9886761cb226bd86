/// Hermite normal form by inserting one generator at a time.
/// Source: [Cohen93, section 2.4]; differs: rational entries, generators one by one, lower-triangular
/// columns.
#include <gmpxx.h>

#include <utility>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"

namespace flatdt::ref {
namespace {

/// The row of the first nonzero entry. Requires: v nonzero.
int pivot_row(const Vector& v) {
  int row = 0;
  while (v[row].is_zero()) ++row;
  return row;
}

/// The unimodular step that turns the entries (x, y) into (g, 0), g > 0 their rational gcd:
/// (u, v) <- (s u + t v, -(y/g) u + (x/g) v). Requires: x = u[row], y = v[row], both nonzero.
void combine_at(int row, Vector& u, Vector& v) {
  const Integer scale = lcm(u[row].denominator(), v[row].denominator());
  const Integer x = (u[row] * scale).numerator(), y = (v[row] * scale).numerator();
  mpz_class g, s, t;
  mpz_gcdext(g.get_mpz_t(), s.get_mpz_t(), t.get_mpz_t(), x.mpz().get_mpz_t(), y.mpz().get_mpz_t());
  const Integer divisor(g);
  Vector pivot = Rational(Integer(s)) * u + Rational(Integer(t)) * v;
  v = Rational(exact_div(x, divisor)) * v - Rational(exact_div(y, divisor)) * u;
  u = std::move(pivot);
}

void check_size(const Vector& v) {
  for (int i = 0; i < v.dimension(); ++i) {
    if (v[i].numerator().bits() > HermiteBasis::kMaxBits ||
        v[i].denominator().bits() > HermiteBasis::kMaxBits)
      throw LimitReached("an entry of the Hermite normal form has more than " +
                         std::to_string(HermiteBasis::kMaxBits) + " bits");
  }
}

}  // namespace

HermiteBasis::HermiteBasis(int dimension) : dimension_(dimension) {}

int HermiteBasis::rank() const {
  return static_cast<int>(vectors_.size());
}

void HermiteBasis::add(const Vector& v) {
  ensure(v.dimension() == dimension_, "a generator has the dimension of its lattice");
  check_size(v);
  Vector rest = v;
  // Every pass either stops or moves the pivot of `rest` down a row: at most d passes, so the numbers grow by
  // a bounded factor in length before check_size sees them.
  for (std::size_t i = 0; !rest.is_zero(); ++i) {
    const int row = pivot_row(rest);
    while (i < vectors_.size() && pivot_row(vectors_[i]) < row) ++i;
    if (i == vectors_.size() || pivot_row(vectors_[i]) > row) {
      const Vector positive = rest[row].sign() == Sign::negative ? -rest : rest;
      vectors_.insert(vectors_.begin() + static_cast<std::ptrdiff_t>(i), positive);
      break;
    }
    combine_at(row, vectors_[i], rest);
  }
  // From the first pivot row down: a later column is zero in the earlier pivot rows and disturbs none of
  // them.
  for (std::size_t j = 1; j < vectors_.size(); ++j) {
    const int row = pivot_row(vectors_[j]);
    for (std::size_t i = 0; i < j; ++i) {
      const Integer multiple = floor(vectors_[i][row] / vectors_[j][row]);
      if (!multiple.is_zero()) vectors_[i] = vectors_[i] - Rational(multiple) * vectors_[j];
    }
  }
  for (const Vector& basis_vector : vectors_) check_size(basis_vector);
}

bool HermiteBasis::contains(const Vector& v) const {
  if (v.dimension() != dimension_) return false;
  Vector rest = v;
  for (const Vector& basis_vector : vectors_) {
    const int row = pivot_row(basis_vector);
    const Rational multiple = rest[row] / basis_vector[row];
    if (!multiple.is_integer()) return false;
    rest = rest - multiple * basis_vector;
  }
  // Rows above a pivot are not repaired by later vectors, so what is left there shows here.
  return rest.is_zero();
}

}  // namespace flatdt::ref
