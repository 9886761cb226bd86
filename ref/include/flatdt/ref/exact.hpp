/// Exact numbers: Sign, Integer, Rational.
/// Invariants: a Rational is always canonical (reduced, positive denominator). Every operator returns a
/// value, never a lazy expression, so that `auto x = a * b` is safe (it is not with GMP's own classes).
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstdint>
#include <string>

namespace flatdt::ref {

/// Sign of an exact number. A product of signs is `a * b`; the opposite is `-a`.
enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) {
  return static_cast<Sign>(-static_cast<int>(s));
}
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}
constexpr Sign sign_of_int(int value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

/// An integer of any size.
class Integer {
 public:
  Integer() = default;
  Integer(int value) : value_(value) {}            // NOLINT(google-explicit-constructor)
  Integer(long value) : value_(value) {}           // NOLINT(google-explicit-constructor)
  Integer(unsigned long value) : value_(value) {}  // NOLINT(google-explicit-constructor)
  explicit Integer(mpz_class value) : value_(std::move(value)) {}
  /// Decimal text `[+-]?[0-9]+`. Throws std::invalid_argument otherwise.
  explicit Integer(const std::string& decimal);

  [[nodiscard]] const mpz_class& mpz() const { return value_; }
  [[nodiscard]] Sign sign() const { return sign_of_int(sgn(value_)); }
  [[nodiscard]] bool is_zero() const { return sgn(value_) == 0; }
  [[nodiscard]] std::size_t bits() const { return mpz_sizeinbase(value_.get_mpz_t(), 2); }
  [[nodiscard]] bool fits_long() const { return value_.fits_slong_p(); }
  /// Requires: fits_long().
  [[nodiscard]] long to_long() const { return value_.get_si(); }
  [[nodiscard]] double to_double() const { return value_.get_d(); }
  [[nodiscard]] std::string to_string() const { return value_.get_str(); }

  Integer& operator+=(const Integer& o) {
    value_ += o.value_;
    return *this;
  }
  Integer& operator-=(const Integer& o) {
    value_ -= o.value_;
    return *this;
  }
  Integer& operator*=(const Integer& o) {
    value_ *= o.value_;
    return *this;
  }
  friend Integer operator+(const Integer& a, const Integer& b) {
    return Integer(mpz_class(a.value_ + b.value_));
  }
  friend Integer operator-(const Integer& a, const Integer& b) {
    return Integer(mpz_class(a.value_ - b.value_));
  }
  friend Integer operator*(const Integer& a, const Integer& b) {
    return Integer(mpz_class(a.value_ * b.value_));
  }
  friend Integer operator-(const Integer& a) { return Integer(mpz_class(-a.value_)); }
  friend bool operator==(const Integer& a, const Integer& b) { return cmp(a.value_, b.value_) == 0; }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    return cmp(a.value_, b.value_) <=> 0;
  }

 private:
  mpz_class value_;
};

/// Quotient rounded towards minus infinity. Requires: b != 0.
Integer floor_div(const Integer& a, const Integer& b);
/// a - b * floor_div(a, b), so in [0, b) for b > 0. Requires: b != 0.
Integer floor_mod(const Integer& a, const Integer& b);
/// a / b where b divides a. Requires: b != 0 and b | a (an InternalError otherwise).
Integer exact_div(const Integer& a, const Integer& b);
Integer gcd(const Integer& a, const Integer& b);
Integer lcm(const Integer& a, const Integer& b);
Integer abs(const Integer& a);

/// A rational number, always canonical.
class Rational {
 public:
  Rational() = default;
  Rational(int value) : value_(value) {}                   // NOLINT(google-explicit-constructor)
  Rational(long value) : value_(value) {}                  // NOLINT(google-explicit-constructor)
  Rational(const Integer& value) : value_(value.mpz()) {}  // NOLINT(google-explicit-constructor)
  /// numerator / denominator. Throws std::invalid_argument if the denominator is zero.
  Rational(const Integer& numerator, const Integer& denominator);
  explicit Rational(mpq_class value) : value_(std::move(value)) { value_.canonicalize(); }

  [[nodiscard]] Integer numerator() const { return Integer(mpz_class(value_.get_num())); }
  [[nodiscard]] Integer denominator() const { return Integer(mpz_class(value_.get_den())); }
  [[nodiscard]] const mpq_class& mpq() const { return value_; }
  [[nodiscard]] Sign sign() const { return sign_of_int(sgn(value_)); }
  [[nodiscard]] bool is_zero() const { return sgn(value_) == 0; }
  [[nodiscard]] bool is_integer() const { return value_.get_den() == 1; }
  /// Truncated towards zero (mpq_get_d): relative error below 2^-52.
  [[nodiscard]] double to_double() const { return value_.get_d(); }
  /// "p" or "p/q", reduced.
  [[nodiscard]] std::string to_string() const { return value_.get_str(); }

  Rational& operator+=(const Rational& o) {
    value_ += o.value_;
    return *this;
  }
  Rational& operator-=(const Rational& o) {
    value_ -= o.value_;
    return *this;
  }
  Rational& operator*=(const Rational& o) {
    value_ *= o.value_;
    return *this;
  }
  /// Adds factor * b; without a division where b is an integer.
  void add_multiple(long factor, const Rational& b) {
    if (b.is_zero()) return;
    if (b.value_.get_den() != 1) {
      value_ += b.value_ * factor;
      return;
    }
    // p/q + f b = (p + f b q) / q stays reduced.
    const mpz_class product = b.value_.get_num() * value_.get_den();
    if (factor >= 0)
      mpz_addmul_ui(value_.get_num_mpz_t(), product.get_mpz_t(), static_cast<unsigned long>(factor));
    else
      mpz_submul_ui(value_.get_num_mpz_t(), product.get_mpz_t(), -static_cast<unsigned long>(factor));
  }
  friend Rational operator+(const Rational& a, const Rational& b) {
    return {Canonical{}, a.value_ + b.value_};
  }
  friend Rational operator-(const Rational& a, const Rational& b) {
    return {Canonical{}, a.value_ - b.value_};
  }
  friend Rational operator*(const Rational& a, const Rational& b) {
    return {Canonical{}, a.value_ * b.value_};
  }
  /// Throws std::invalid_argument if b is zero (GMP would raise SIGFPE).
  friend Rational operator/(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a) { return {Canonical{}, -a.value_}; }
  friend bool operator==(const Rational& a, const Rational& b) { return a.value_ == b.value_; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return cmp(a.value_, b.value_) <=> 0;
  }

 private:
  struct Canonical {};
  /// The value of one of GMP's expressions, which are canonical if their operands are: made in place, for
  /// every copy of an mpq_class allocates twice.
  template <class Expression>
  Rational(Canonical, const Expression& expression) : value_(expression) {}

  mpq_class value_;
};

Integer floor(const Rational& a);
/// floor(a + 1/2).
Integer round_half_up(const Rational& a);
Rational abs(const Rational& a);

}  // namespace flatdt::ref
