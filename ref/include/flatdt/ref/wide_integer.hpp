/// Signed integers of a fixed number of 64-bit limbs, for the fixed-width stage of the predicates.
/// Invariant: two's complement, least significant limb first. No operation looks for an overflow:
/// fixed_predicates.hpp proves that none occurs there. Nothing is allocated.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "flatdt/ref/exact.hpp"

namespace flatdt::ref {

__extension__ using Int128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

template <std::size_t N>
struct WideInteger {
  std::array<std::uint64_t, N> limb{};

  [[nodiscard]] bool is_negative() const { return (limb[N - 1] >> 63U) != 0; }
  [[nodiscard]] Sign sign() const {
    if (is_negative()) return Sign::negative;
    for (const std::uint64_t x : limb)
      if (x != 0) return Sign::positive;
    return Sign::zero;
  }

  [[nodiscard]] WideInteger operator-() const {
    WideInteger result;
    result -= *this;
    return result;
  }
  friend bool operator==(const WideInteger&, const WideInteger&) = default;
  /// Requires: a - b does not overflow.
  friend bool operator<(const WideInteger& a, const WideInteger& b) {
    WideInteger difference = a;
    difference -= b;
    return difference.is_negative();
  }

  WideInteger& operator+=(const WideInteger& o) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const Unsigned128 sum = static_cast<Unsigned128>(limb[i]) + o.limb[i] + carry;
      limb[i] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64U);
    }
    return *this;
  }
  WideInteger& operator-=(const WideInteger& o) {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const Unsigned128 difference = static_cast<Unsigned128>(limb[i]) - o.limb[i] - borrow;
      limb[i] = static_cast<std::uint64_t>(difference);
      borrow = static_cast<std::uint64_t>(difference >> 64U) & 1U;
    }
    return *this;
  }
};

/// The same number in N limbs. Requires: N >= 2.
template <std::size_t N>
[[nodiscard]] WideInteger<N> widened(Int128 value) {
  WideInteger<N> result;
  const auto bits = static_cast<Unsigned128>(value);
  result.limb[0] = static_cast<std::uint64_t>(bits);
  result.limb[1] = static_cast<std::uint64_t>(bits >> 64U);
  for (std::size_t i = 2; i < N; ++i) result.limb[i] = value < 0 ? ~std::uint64_t{0} : 0;
  return result;
}

/// The same number in more limbs.
template <std::size_t N, std::size_t M>
[[nodiscard]] WideInteger<N> extended(const WideInteger<M>& value) {
  WideInteger<N> result;
  for (std::size_t i = 0; i < N; ++i)
    result.limb[i] = i < M ? value.limb[i] : value.is_negative() ? ~std::uint64_t{0} : 0;
  return result;
}

/// a b, exactly. The product of the unsigned limbs is corrected for each negative factor: with a = u - 2^(64
/// N) the product lacks -2^(64 N) b. Without branches: signs are as good as random where this is used.
template <std::size_t N, std::size_t M>
[[nodiscard]] WideInteger<N + M> multiply(const WideInteger<N>& a, const WideInteger<M>& b) {
  WideInteger<N + M> result;
  for (std::size_t i = 0; i < N; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < M; ++j) {
      const Unsigned128 term = static_cast<Unsigned128>(a.limb[i]) * b.limb[j] + result.limb[i + j] + carry;
      result.limb[i + j] = static_cast<std::uint64_t>(term);
      carry = static_cast<std::uint64_t>(term >> 64U);
    }
    result.limb[i + M] = carry;
  }
  const auto subtract_high = [&result](const auto& factor, std::size_t from, std::uint64_t mask) {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; from + i < N + M; ++i) {
      const Unsigned128 difference =
          static_cast<Unsigned128>(result.limb[from + i]) - (factor.limb[i] & mask) - borrow;
      result.limb[from + i] = static_cast<std::uint64_t>(difference);
      borrow = static_cast<std::uint64_t>(difference >> 64U) & 1U;
    }
  };
  subtract_high(b, N, -(a.limb[N - 1] >> 63U));
  subtract_high(a, M, -(b.limb[M - 1] >> 63U));
  return result;
}

}  // namespace flatdt::ref
