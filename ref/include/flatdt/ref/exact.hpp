/// Exact numbers: Sign, Integer, Rational.
/// Invariants: a Rational is always canonical (reduced, positive denominator). Every operator returns a
/// value, never a lazy expression, so that `auto x = a * b` is safe (it is not with GMP's own classes).
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstdint>
#include <string>
#include <utility>

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

/// A rational number, always canonical: 16 bytes where both its numbers are below 2^63 in magnitude, as
/// nearly all are that points come with, else a number of GMP's. Invariant: that form is taken whenever it
/// can be, so equal values have equal forms.
class Rational {
 public:
  Rational() = default;
  Rational(int value) : value_{value} {}  // NOLINT(google-explicit-constructor)
  Rational(long value) {                  // NOLINT(google-explicit-constructor)
    if (value == kLeast)
      set_large(mpq_class(value));
    else
      value_.numerator = value;
  }
  Rational(const Integer& value);  // NOLINT(google-explicit-constructor)
  /// numerator / denominator. Throws std::invalid_argument if the denominator is zero.
  Rational(const Integer& numerator, const Integer& denominator);
  explicit Rational(mpq_class value) {
    value.canonicalize();
    set(std::move(value));
  }
  /// numerator / denominator. Requires: denominator > 0, numerator > -2^63.
  static Rational ratio(std::int64_t numerator, std::int64_t denominator);

  Rational(const Rational& o) : value_(o.value_), denominator_(o.denominator_) {
    if (!is_small()) set_large(*o.large());
  }
  Rational(Rational&& o) noexcept : value_(o.value_), denominator_(o.denominator_) {
    if (!is_small()) o.forget();
  }
  Rational& operator=(const Rational& o) {
    if (this != &o) *this = Rational(o);
    return *this;
  }
  Rational& operator=(Rational&& o) noexcept {
    std::swap(value_, o.value_);
    std::swap(denominator_, o.denominator_);
    return *this;
  }
  ~Rational() {
    if (!is_small()) delete large();
  }

  /// Both numbers are below 2^63 in magnitude.
  [[nodiscard]] bool is_small() const { return denominator_ != 0; }
  /// Requires: is_small().
  [[nodiscard]] std::int64_t small_numerator() const { return value_.numerator; }
  [[nodiscard]] std::int64_t small_denominator() const { return denominator_; }

  [[nodiscard]] Integer numerator() const;
  [[nodiscard]] Integer denominator() const;
  [[nodiscard]] mpq_class mpq() const;
  [[nodiscard]] Sign sign() const {
    return is_small()
               ? sign_of_int(static_cast<int>(value_.numerator > 0) - static_cast<int>(value_.numerator < 0))
               : sign_of_int(sgn(*large()));
  }
  [[nodiscard]] bool is_zero() const { return is_small() && value_.numerator == 0; }
  [[nodiscard]] bool is_integer() const;
  /// Truncated towards zero (mpq_get_d): relative error below 2^-52.
  [[nodiscard]] double to_double() const;
  /// "p" or "p/q", reduced.
  [[nodiscard]] std::string to_string() const;

  Rational& operator+=(const Rational& o) { return *this = *this + o; }
  Rational& operator-=(const Rational& o) { return *this = *this - o; }
  Rational& operator*=(const Rational& o) { return *this = *this * o; }
  /// Adds factor * b.
  void add_multiple(long factor, const Rational& b) {
    if (!b.is_zero()) *this += Rational(factor) * b;
  }
  friend Rational operator+(const Rational& a, const Rational& b) {
    if (a.is_small() && b.is_small()) return sum(a, b.value_.numerator, b.denominator_);
    return Rational(Canonical{}, a.mpq() + b.mpq());
  }
  friend Rational operator-(const Rational& a, const Rational& b) {
    if (a.is_small() && b.is_small()) return sum(a, -b.value_.numerator, b.denominator_);
    return Rational(Canonical{}, a.mpq() - b.mpq());
  }
  friend Rational operator*(const Rational& a, const Rational& b) {
    if (a.is_small() && b.is_small()) return product(a, b.value_.numerator, b.denominator_);
    return Rational(Canonical{}, a.mpq() * b.mpq());
  }
  /// Throws std::invalid_argument if b is zero (GMP would raise SIGFPE).
  friend Rational operator/(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a) {
    if (!a.is_small()) return Rational(Canonical{}, -*a.large());
    Rational result = a;
    result.value_.numerator = -a.value_.numerator;
    return result;
  }
  friend bool operator==(const Rational& a, const Rational& b) {
    if (a.denominator_ != b.denominator_) return false;
    return a.is_small() ? a.value_.numerator == b.value_.numerator : *a.large() == *b.large();
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

 private:
  struct Canonical {};
  static constexpr std::int64_t kLeast = INT64_MIN;

  /// The value of one of GMP's expressions, which are canonical if their operands are.
  template <class Expression>
  Rational(Canonical, const Expression& expression) {
    set(mpq_class(expression));
  }
  /// a + numerator / denominator and a * (numerator / denominator), all small.
  static Rational sum(const Rational& a, std::int64_t numerator, std::int64_t denominator);
  static Rational product(const Rational& a, std::int64_t numerator, std::int64_t denominator);
  /// Requires: reduced, the denominator positive, both numbers below 2^127 in magnitude.
  __extension__ static Rational reduced(__int128 numerator, __int128 denominator);
  /// Requires: canonical; the present value is small.
  void set(mpq_class value);
  void set_large(mpq_class value) {
    value_.large = new mpq_class(std::move(value));
    denominator_ = 0;
  }
  /// Requires: !is_small().
  [[nodiscard]] mpq_class* large() const {
    // The analyzer takes the storage of an emptied std::optional for destroyed a second time.
    return value_.large;  // NOLINT(clang-analyzer-cplusplus.NewDelete)
  }
  void forget() {
    value_.numerator = 0;
    denominator_ = 1;
  }

  union Value {
    std::int64_t numerator = 0;
    mpq_class* large;  // owned
  };
  Value value_;  // `large` if the denominator is 0
  std::int64_t denominator_ = 1;
};

Integer floor(const Rational& a);
/// floor(a + 1/2).
Integer round_half_up(const Rational& a);
Rational abs(const Rational& a);

}  // namespace flatdt::ref
