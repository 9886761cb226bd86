#include "flatdt/ref/exact.hpp"

#include <stdexcept>

#include "flatdt/ref/errors.hpp"

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

Rational::Rational(const Integer& numerator, const Integer& denominator) {
  if (denominator.is_zero()) throw std::invalid_argument("denominator 0");
  value_ = mpq_class(numerator.mpz(), denominator.mpz());
  value_.canonicalize();
}

Rational operator/(const Rational& a, const Rational& b) {
  if (b.is_zero()) throw std::invalid_argument("division by 0");
  return {Rational::Canonical{}, a.value_ / b.value_};
}

Integer floor(const Rational& a) {
  return floor_div(a.numerator(), a.denominator());
}

Integer round_half_up(const Rational& a) {
  return floor(a + Rational(Integer(1), Integer(2)));
}

Rational abs(const Rational& a) {
  return a.sign() == Sign::negative ? -a : a;
}

}  // namespace flatdt::ref
