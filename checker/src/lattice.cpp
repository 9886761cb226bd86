#include "lattice.hpp"

#include <string>
#include <utility>

#include "flatdt/checker/errors.hpp"

namespace flatdt::checker {
namespace {

/// v -= q w.
void subtract_multiple(Vec<Integer>& v, const Integer& q, const Vec<Integer>& w) {
  for (std::size_t i = 0; i < 3; ++i) mpz_submul(v[i].get_mpz_t(), q.get_mpz_t(), w[i].get_mpz_t());
}

Integer floor_quotient(const Integer& a, const Integer& b) {
  Integer q;
  mpz_fdiv_q(q.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  return q;
}

bool divides(const Integer& a, const Integer& b) {
  return mpz_divisible_p(b.get_mpz_t(), a.get_mpz_t()) != 0;
}

}  // namespace

void require_size(const Integer& x, const char* what) {
  if (mpz_sizeinbase(x.get_mpz_t(), 2) > kMaxGroupBits) {
    throw ResourceLimit(std::string(what) + " has more than " + std::to_string(kMaxGroupBits) + " bits");
  }
}

void Lattice::insert(const Vec<Rational>& v) {
  Integer common = denominator_;
  for (std::size_t i = 0; i < dimension_; ++i) {
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), v[i].get_den().get_mpz_t());
    require_size(common, "the common denominator of the lattice");
  }
  if (common != denominator_) {
    const Integer factor = common / denominator_;
    for (auto& row : rows_) {
      if (row) {
        for (Integer& x : *row) x *= factor;
      }
    }
    denominator_ = common;
  }
  Vec<Integer> integral;
  for (std::size_t i = 0; i < dimension_; ++i) integral[i] = v[i].get_num() * (denominator_ / v[i].get_den());
  insert_integral(std::move(integral));
}

void Lattice::insert_integral(Vec<Integer> v) {
  bool changed = false;
  for (std::size_t c = 0; c < dimension_; ++c) {
    if (v[c] == 0) continue;
    if (!rows_[c]) {
      if (v[c] < 0) {
        for (Integer& x : v) x = -x;
      }
      rows_[c] = std::move(v);
      changed = true;
      break;
    }
    Vec<Integer>& row = *rows_[c];
    if (divides(row[c], v[c])) {
      subtract_multiple(v, Integer(v[c] / row[c]), row);
      continue;
    }
    // The unimodular step (row, v) -> (s row + t v, (v_c/g) row - (row_c/g) v) with g = s row_c + t v_c.
    Integer g;
    Integer s;
    Integer t;
    mpz_gcdext(g.get_mpz_t(), s.get_mpz_t(), t.get_mpz_t(), row[c].get_mpz_t(), v[c].get_mpz_t());
    const Integer a = v[c] / g;
    const Integer b = row[c] / g;
    for (std::size_t i = c; i < dimension_; ++i) {
      const Integer combined = s * row[i] + t * v[i];
      v[i] = a * row[i] - b * v[i];
      row[i] = combined;
    }
    changed = true;
  }
  if (changed) normalise();
}

void Lattice::normalise() {
  for (std::size_t c = dimension_; c-- > 0;) {
    for (std::size_t k = c + 1; k < dimension_; ++k) {
      if (rows_[c] && rows_[k])
        subtract_multiple(*rows_[c], floor_quotient((*rows_[c])[k], (*rows_[k])[k]), *rows_[k]);
    }
    if (!rows_[c]) continue;
    for (const Integer& x : *rows_[c]) require_size(x, "an entry of the lattice's basis");
  }
}

bool Lattice::contains(const Vec<Rational>& v) const {
  Vec<Integer> rest;
  for (std::size_t i = 0; i < dimension_; ++i) {
    if (!divides(v[i].get_den(), denominator_)) return false;
    rest[i] = v[i].get_num() * (denominator_ / v[i].get_den());
  }
  for (std::size_t c = 0; c < dimension_; ++c) {
    if (rest[c] == 0) continue;
    if (!rows_[c] || !divides((*rows_[c])[c], rest[c])) return false;
    subtract_multiple(rest, Integer(rest[c] / (*rows_[c])[c]), *rows_[c]);
  }
  return true;
}

int Lattice::rank() const {
  int rank = 0;
  for (const auto& row : rows_) rank += row ? 1 : 0;
  return rank;
}

Mat<Rational> Lattice::basis() const {
  Mat<Rational> columns;
  for (std::size_t i = 0; i < dimension_; ++i) {
    for (std::size_t c = 0; c < dimension_; ++c) {
      columns[i][c] = Rational(rows_.at(c).value()[i], denominator_);
      columns[i][c].canonicalize();
    }
  }
  return columns;
}

void Lattice::reduce(Vec<Integer>& v) const {
  for (std::size_t c = 0; c < dimension_; ++c) {
    const Vec<Integer>& row = rows_.at(c).value();
    subtract_multiple(v, floor_quotient(v[c], row[c]), row);
  }
}

}  // namespace flatdt::checker
