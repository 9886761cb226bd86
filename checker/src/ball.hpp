// Certified floating point: a double with a bound on its distance from the exact value.
//
// Invariants: |mid - exact| <= rad, or rad is infinite or NaN (nothing is known).
// Bounds: u = 2^-53 is the unit roundoff; fl(x op y) = (x op y)(1+e) + f with |e| <= u, |f| <= 2^-1074 (f = 0
// for + and
// -). A radius is the sum of at most four terms of products, so at most eight roundings, each losing a factor
// of at least 1 - u or an amount of at most 2^-1074; the factor 1 + 2^-48 and the summand 2^-1000 outweigh
// them. Requires: round to nearest, no contraction, no fast-math.   Source: docs/soundness.md, section 5.
#pragma once

#include <cmath>
#include <optional>

#include "flatdt/checker/exact.hpp"

namespace flatdt::checker {

struct Ball {
  double mid = 0;
  double rad = 0;
};

inline constexpr double kUnitRoundoff = 0x1p-53;

[[nodiscard]] inline double inflate(double bound) {
  return bound * (1 + 0x1p-48) + 0x1p-1000;
}

[[nodiscard]] inline Ball operator+(const Ball& a, const Ball& b) {
  const double m = a.mid + b.mid;
  return {m, inflate(a.rad + b.rad + std::fabs(m) * kUnitRoundoff)};
}

[[nodiscard]] inline Ball operator-(const Ball& a, const Ball& b) {
  const double m = a.mid - b.mid;
  return {m, inflate(a.rad + b.rad + std::fabs(m) * kUnitRoundoff)};
}

[[nodiscard]] inline Ball operator*(const Ball& a, const Ball& b) {
  const double m = a.mid * b.mid;
  return {m, inflate(std::fabs(a.mid) * b.rad + a.rad * (std::fabs(b.mid) + b.rad) +
                     std::fabs(m) * kUnitRoundoff)};
}

/// x with its rounding error. mpq_get_d truncates: the relative error is below 2 u, and an underflow loses <
/// 2^-1000. An infinite result has an infinite radius.
[[nodiscard]] inline Ball to_ball(const Rational& x) {
  const double m = x.get_d();
  return {m, inflate(2 * kUnitRoundoff * std::fabs(m))};
}

/// The sign of the exact value where the bound decides it; never zero. A NaN decides nothing.
[[nodiscard]] inline std::optional<Sign> certain_sign(const Ball& a) {
  if (a.mid > a.rad) return Sign::positive;
  if (a.mid < -a.rad) return Sign::negative;
  return std::nullopt;
}

}  // namespace flatdt::checker
