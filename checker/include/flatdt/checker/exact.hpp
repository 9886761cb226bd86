// Exact numbers and the small vectors and matrices made of them.
//
// Invariants: only the first d entries (rows, columns) mean anything in dimension d; the others stay zero.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace flatdt::checker {

using Integer = mpz_class;
using Rational = mpq_class;

template <class T>
using Vec = std::array<T, 3>;
template <class T>
using Mat = std::array<std::array<T, 3>, 3>;

/// The sign of an exact number.
enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

/// Sign of an exact number.
template <class Number>
[[nodiscard]] Sign sign_of(const Number& x) {
  const int s = sgn(x);
  return s < 0 ? Sign::negative : s > 0 ? Sign::positive : Sign::zero;
}

/// -s.
[[nodiscard]] constexpr Sign opposite(Sign s) {
  return static_cast<Sign>(-static_cast<int>(s));
}

/// The affine map x -> linear x + translation on column vectors: the Seitz symbol {R|t}.
struct Seitz {
  Mat<Rational> linear;
  Vec<Rational> translation;
};

}  // namespace flatdt::checker
