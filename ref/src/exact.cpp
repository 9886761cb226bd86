#include "flatdt/ref/exact.hpp"

#include <array>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/wide_integer.hpp"

namespace flatdt::ref {

Integer::Integer(const std::string& decimal) {
  const std::size_t start = !decimal.empty() && (decimal[0] == '+' || decimal[0] == '-') ? 1 : 0;
  if (decimal.size() == start || decimal.find_first_not_of("0123456789", start) != std::string::npos)
    throw std::invalid_argument("not a decimal integer: " + decimal.substr(0, 40));
  value_.set_str(decimal.substr(decimal[0] == '+' ? 1 : 0), 10);
}

Integer floor_div(const Integer& a, const Integer& b) {
  ensure(!b.is_zero(), "floor_div by zero");
  mpz_class q;
  mpz_fdiv_q(q.get_mpz_t(), a.mpz().get_mpz_t(), b.mpz().get_mpz_t());
  return Integer(q);
}

Integer floor_mod(const Integer& a, const Integer& b) {
  return a - b * floor_div(a, b);
}

Integer exact_div(const Integer& a, const Integer& b) {
  ensure(!b.is_zero() && mpz_divisible_p(a.mpz().get_mpz_t(), b.mpz().get_mpz_t()) != 0,
         "exact_div is exact");
  mpz_class q;
  mpz_divexact(q.get_mpz_t(), a.mpz().get_mpz_t(), b.mpz().get_mpz_t());
  return Integer(q);
}

Integer gcd(const Integer& a, const Integer& b) {
  mpz_class g;
  mpz_gcd(g.get_mpz_t(), a.mpz().get_mpz_t(), b.mpz().get_mpz_t());
  return Integer(g);
}

Integer lcm(const Integer& a, const Integer& b) {
  mpz_class m;
  mpz_lcm(m.get_mpz_t(), a.mpz().get_mpz_t(), b.mpz().get_mpz_t());
  return Integer(m);
}

Integer abs(const Integer& a) {
  return a.sign() == Sign::negative ? -a : a;
}

Rational::Rational(const Integer& value) {
  set(mpq_class(value.mpz()));
}

Rational::Rational(const Integer& numerator, const Integer& denominator) {
  if (denominator.is_zero()) throw std::invalid_argument("denominator 0");
  mpq_class value(numerator.mpz(), denominator.mpz());
  value.canonicalize();
  set(std::move(value));
}

Rational Rational::ratio(std::int64_t numerator, std::int64_t denominator) {
  ensure(denominator > 0 && numerator != kLeast, "a ratio of machine integers is of small ones");
  const std::int64_t g = std::gcd(numerator, denominator);
  Rational result;
  result.value_.numerator = numerator / g;
  result.denominator_ = denominator / g;
  return result;
}

void Rational::set(mpq_class value) {
  const mpq_srcptr q = value.get_mpq_t();
  if (mpz_fits_slong_p(mpq_numref(q)) != 0 && mpz_fits_slong_p(mpq_denref(q)) != 0 &&
      mpz_get_si(mpq_numref(q)) != kLeast) {
    value_.numerator = mpz_get_si(mpq_numref(q));
    denominator_ = mpz_get_si(mpq_denref(q));
  } else {
    set_large(std::move(value));
  }
}

Integer Rational::numerator() const {
  return is_small() ? Integer(long{value_.numerator}) : Integer(mpz_class(large()->get_num()));
}

Integer Rational::denominator() const {
  return is_small() ? Integer(long{denominator_}) : Integer(mpz_class(large()->get_den()));
}

bool Rational::is_integer() const {
  return is_small() ? denominator_ == 1 : large()->get_den() == 1;
}

mpq_class Rational::mpq() const {
  if (!is_small()) return *large();
  mpq_class value;
  mpz_set_si(value.get_num_mpz_t(), value_.numerator);
  mpz_set_si(value.get_den_mpz_t(), denominator_);
  return value;
}

Rational Rational::reduced(Int128 numerator, Int128 denominator) {
  constexpr Int128 kMost = std::numeric_limits<std::int64_t>::max();
  Rational result;
  if (numerator <= kMost && numerator >= -kMost && denominator <= kMost) {
    result.value_.numerator = static_cast<std::int64_t>(numerator);
    result.denominator_ = static_cast<std::int64_t>(denominator);
    return result;
  }
  const auto assign = [](mpz_ptr to, Int128 magnitude) {
    const std::array<std::uint64_t, 2> words{static_cast<std::uint64_t>(magnitude),
                                             static_cast<std::uint64_t>(magnitude >> 64U)};
    mpz_import(to, 2, -1, sizeof words[0], 0, 0, words.data());
  };
  mpq_class value;
  assign(value.get_num_mpz_t(), numerator < 0 ? -numerator : numerator);
  assign(value.get_den_mpz_t(), denominator);
  if (numerator < 0) mpz_neg(value.get_num_mpz_t(), value.get_num_mpz_t());
  result.set_large(std::move(value));
  return result;
}

/// With a/(g b) and c/(g d), b and d coprime, the sum is (a d + c b) / (g b d). A prime that divides b
/// divides neither a nor d, so not the numerator, and likewise for d: only a divisor of g can be taken out.
/// Products of two numbers below 2^63 are below 2^126.
Rational Rational::sum(const Rational& a, std::int64_t numerator, std::int64_t denominator) {
  if (a.denominator_ == 1 && denominator == 1) return reduced(Int128{a.value_.numerator} + numerator, 1);
  const std::int64_t g = std::gcd(a.denominator_, denominator);
  const Int128 total =
      Int128{a.value_.numerator} * (denominator / g) + Int128{numerator} * (a.denominator_ / g);
  if (g == 1) return reduced(total, Int128{a.denominator_} * denominator);
  const std::int64_t h = std::gcd(static_cast<std::int64_t>(total % g), g);
  return reduced(total / h, Int128{a.denominator_ / g} * (denominator / h));
}

Rational Rational::product(const Rational& a, std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t g = denominator == 1 ? 1 : std::gcd(a.value_.numerator, denominator);
  const std::int64_t h = a.denominator_ == 1 ? 1 : std::gcd(numerator, a.denominator_);
  return reduced(Int128{a.value_.numerator / g} * (numerator / h),
                 Int128{a.denominator_ / h} * (denominator / g));
}

double Rational::to_double() const {
  return is_small() ? mpq().get_d() : large()->get_d();
}

std::string Rational::to_string() const {
  if (!is_small()) return large()->get_str();
  std::string text = std::to_string(value_.numerator);
  if (denominator_ != 1) text += "/" + std::to_string(denominator_);
  return text;
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  if (!a.is_small() || !b.is_small()) return cmp(a.mpq(), b.mpq()) <=> 0;
  if (a.denominator_ == b.denominator_) return a.value_.numerator <=> b.value_.numerator;
  return Int128{a.value_.numerator} * b.denominator_ <=> Int128{b.value_.numerator} * a.denominator_;
}

// The analyzer loses the destructors of values that are returned: the sanitizers look for leaks.
// NOLINTBEGIN(clang-analyzer-cplusplus.NewDeleteLeaks)
Rational operator/(const Rational& a, const Rational& b) {
  if (b.is_zero()) throw std::invalid_argument("division by 0");
  if (!a.is_small() || !b.is_small()) return Rational(Rational::Canonical{}, a.mpq() / b.mpq());
  return b.value_.numerator > 0 ? Rational::product(a, b.denominator_, b.value_.numerator)
                                : Rational::product(a, -b.denominator_, -b.value_.numerator);
}

Integer floor(const Rational& a) {
  if (a.is_small()) {
    const std::int64_t quotient = a.small_numerator() / a.small_denominator();
    return Integer(long{quotient} - static_cast<long>(a.small_numerator() % a.small_denominator() < 0));
  }
  return floor_div(a.numerator(), a.denominator());
}

Integer round_half_up(const Rational& a) {
  return floor(a + Rational(Integer(1), Integer(2)));
}

Rational abs(const Rational& a) {
  return a.sign() == Sign::negative ? -a : a;
}
// NOLINTEND(clang-analyzer-cplusplus.NewDeleteLeaks)

}  // namespace flatdt::ref
