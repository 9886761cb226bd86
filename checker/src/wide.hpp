// Signed integers of a fixed number of 64-bit limbs, in two's complement.
//
// A product has as many limbs as its factors together and is always exact: |a b| <= 2^(64(A+B) - 2). Sums and
// differences have the limbs of their terms, and whoever adds proves that the result fits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "flatdt/checker/exact.hpp"

namespace flatdt::checker {

__extension__ using DoubleLimb = unsigned __int128;
__extension__ using SignedDoubleLimb = __int128;

template <std::size_t N>
struct Wide {
  std::array<std::uint64_t, N> limb{};  ///< least first

  [[nodiscard]] bool is_negative() const { return limb[N - 1] >> 63 != 0; }

  /// The same number in N limbs or more.
  template <std::size_t M>
  [[nodiscard]] Wide<M> widened() const {
    static_assert(M >= N);
    Wide<M> w;
    for (std::size_t i = 0; i < M; ++i) w.limb[i] = i < N ? limb[i] : (is_negative() ? ~std::uint64_t{0} : 0);
    return w;
  }
};

[[nodiscard]] inline Wide<1> wide(std::int64_t x) {
  return {{static_cast<std::uint64_t>(x)}};
}

/// Modulo 2^(64 N).
template <std::size_t N>
[[nodiscard]] Wide<N> operator+(const Wide<N>& a, const Wide<N>& b) {
  Wide<N> sum;
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const DoubleLimb s = DoubleLimb{a.limb[i]} + b.limb[i] + carry;
    sum.limb[i] = static_cast<std::uint64_t>(s);
    carry = static_cast<std::uint64_t>(s >> 64);
  }
  return sum;
}

/// Modulo 2^(64 N).
template <std::size_t N>
[[nodiscard]] Wide<N> operator-(const Wide<N>& a, const Wide<N>& b) {
  Wide<N> difference;
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const DoubleLimb s = DoubleLimb{a.limb[i]} - b.limb[i] - borrow;
    difference.limb[i] = static_cast<std::uint64_t>(s);
    borrow = static_cast<std::uint64_t>(s >> 64) & 1;
  }
  return difference;
}

/// Schoolbook on the limbs as unsigned numbers ua, ub. With a = ua - 2^(64A) [a < 0] and b likewise,
/// ab = ua ub - 2^(64A) [a < 0] ub - 2^(64B) [b < 0] ua modulo 2^(64(A+B)).
template <std::size_t A, std::size_t B>
[[nodiscard]] Wide<A + B> operator*(const Wide<A>& a, const Wide<B>& b) {
  Wide<A + B> product;
  for (std::size_t i = 0; i < A; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < B; ++j) {
      const DoubleLimb s = DoubleLimb{a.limb[i]} * b.limb[j] + product.limb[i + j] + carry;
      product.limb[i + j] = static_cast<std::uint64_t>(s);
      carry = static_cast<std::uint64_t>(s >> 64);
    }
    product.limb[i + B] = carry;
  }
  const std::uint64_t a_mask = a.is_negative() ? ~std::uint64_t{0} : 0;
  const std::uint64_t b_mask = b.is_negative() ? ~std::uint64_t{0} : 0;
  Wide<A + B> correction_a;
  Wide<A + B> correction_b;
  for (std::size_t j = 0; j < B; ++j) correction_a.limb[A + j] = b.limb[j] & a_mask;
  for (std::size_t i = 0; i < A; ++i) correction_b.limb[B + i] = a.limb[i] & b_mask;
  return product - correction_a - correction_b;
}

/// The same of single limbs, which the machine multiplies.
[[nodiscard]] inline Wide<2> operator*(const Wide<1>& a, const Wide<1>& b) {
  const SignedDoubleLimb product =
      SignedDoubleLimb{static_cast<std::int64_t>(a.limb[0])} * static_cast<std::int64_t>(b.limb[0]);
  return {{static_cast<std::uint64_t>(product), static_cast<std::uint64_t>(product >> 64)}};
}

template <std::size_t N>
[[nodiscard]] Sign sign_of(const Wide<N>& x) {
  if (x.is_negative()) return Sign::negative;
  for (const std::uint64_t limb : x.limb) {
    if (limb != 0) return Sign::positive;
  }
  return Sign::zero;
}

/// |x|.   Requires: x is not the least number.
template <std::size_t N>
[[nodiscard]] Wide<N> magnitude(const Wide<N>& x) {
  return x.is_negative() ? Wide<N>{} - x : x;
}

/// As an integer of any size.   Requires: x is not negative.
template <std::size_t N>
[[nodiscard]] Integer to_integer(const Wide<N>& x) {
  Integer result;
  mpz_import(result.get_mpz_t(), N, -1, sizeof(std::uint64_t), 0, 0, x.limb.data());
  return result;
}

}  // namespace flatdt::checker
