// NUMBER tokens: rationals, decimals and hexadecimals, read without rounding.
// The grammar is checked by hand before GMP sees a digit: GMP would accept white space and other bases, and
// it raises SIGFPE on a zero denominator.   Source: FORMAT.md, "Lexical rules".
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "lexer.hpp"

namespace flatdt::checker {
namespace {

/// The largest absolute value of an exponent, and what is said of a larger one.
struct ExponentLimit {
  long most;
  std::string_view fault;
};
constexpr ExponentLimit kDecimalExponents{1100, "exponent beyond 1100"};
constexpr ExponentLimit kBinaryExponents{4400, "exponent beyond 4400"};

bool is_digit(char c, int base) {
  if (c >= '0' && c <= '9') return true;
  return base == 16 && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'));
}

/// Consumes the longest prefix of digits.
std::string take_digits(std::string_view& rest, int base) {
  std::size_t n = 0;
  while (n < rest.size() && is_digit(rest[n], base)) ++n;
  std::string digits(rest.substr(0, n));
  rest.remove_prefix(n);
  return digits;
}

bool take(std::string_view& rest, char lower, char upper) {
  if (rest.empty() || (rest[0] != lower && rest[0] != upper)) return false;
  rest.remove_prefix(1);
  return true;
}

bool take_minus(std::string_view& rest) {
  const bool minus = take(rest, '-', '-');
  if (!minus) take(rest, '+', '+');
  return minus;
}

/// Nothing, and why.
std::nullopt_t none(std::string_view& fault, std::string_view reason) {
  fault = reason;
  return std::nullopt;
}

/// The rest of the token as [+-]?[0-9]+ of absolute value at most the limit. Nothing if it is not, and then
/// `fault` says why; so in all functions below.
std::optional<long> take_exponent(std::string_view& rest, const ExponentLimit& limit,
                                  std::string_view& fault) {
  const bool minus = take_minus(rest);
  const std::string digits = take_digits(rest, 10);
  if (digits.empty()) return none(fault, "an exponent needs digits");
  long value = 0;
  for (const char c : digits) {
    if (value <= limit.most) value = 10 * value + (c - '0');  // stops growing once above the limit
  }
  if (value > limit.most) return none(fault, limit.fault);
  return minus ? -value : value;
}

/// mantissa * base^exponent.
Rational scaled(const Integer& mantissa, unsigned long base, long exponent) {
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), base, static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  Rational value(mantissa);
  if (exponent < 0) {
    value /= Rational(power);
  } else {
    value *= Rational(power);
  }
  return value;
}

/// What follows the digits before the point.
std::optional<Rational> parse_positional(std::string_view rest, const std::string& whole, int base,
                                         std::string_view& fault) {
  std::string fraction;
  if (take(rest, '.', '.')) fraction = take_digits(rest, base);
  if (whole.empty() && fraction.empty()) return none(fault, "a number needs digits");
  const long places = static_cast<long>(fraction.size());
  const Integer mantissa(whole + fraction, base);
  std::optional<long> exponent = 0;
  if (base == 16) {
    if (take(rest, 'p', 'P')) exponent = take_exponent(rest, kBinaryExponents, fault);
  } else if (take(rest, 'e', 'E')) {
    exponent = take_exponent(rest, kDecimalExponents, fault);
  }
  if (!exponent) return std::nullopt;
  if (!rest.empty()) return none(fault, "not a rational, decimal or hexadecimal number");
  return base == 16 ? scaled(mantissa, 2, *exponent - 4 * places) : scaled(mantissa, 10, *exponent - places);
}

/// Consumes a prefix of at most 18 digits: a value below 10^18, which a long holds. Nothing if there are
/// none, or more.
std::optional<long> take_small(std::string_view& rest) {
  constexpr std::size_t kMostDigits = 18;
  long value = 0;
  std::size_t n = 0;
  for (; n < rest.size() && is_digit(rest[n], 10); ++n) {
    if (n == kMostDigits) return std::nullopt;
    value = 10 * value + (rest[n] - '0');
  }
  if (n == 0) return std::nullopt;
  rest.remove_prefix(n);
  return value;
}

/// The most frequent numbers: rationals of short numerator and denominator. False for all other tokens, bad
/// ones too.
bool read_small(std::string_view rest, Rational& value) {
  const std::optional<long> numerator = take_small(rest);
  if (!numerator) return false;
  std::optional<long> denominator = 1;
  if (!rest.empty()) {
    if (!take(rest, '/', '/')) return false;
    denominator = take_small(rest);
    if (!denominator || *denominator == 0 || !rest.empty()) return false;
  }
  const long common = std::gcd(*numerator, *denominator);
  mpq_set_si(value.get_mpq_t(), *numerator / common, static_cast<unsigned long>(*denominator / common));
  return true;
}

/// All other numbers.
std::optional<Rational> parse_magnitude(std::string_view rest, std::string_view& fault) {
  std::string_view after = rest;
  if (take(after, '0', '0') && take(after, 'x', 'X')) {
    const std::string hexadecimal = take_digits(after, 16);
    return parse_positional(after, hexadecimal, 16, fault);
  }
  const std::string whole = take_digits(rest, 10);
  if (rest.empty() && !whole.empty()) return Rational(Integer(whole, 10));
  if (whole.empty() || !take(rest, '/', '/')) return parse_positional(rest, whole, 10, fault);
  const std::string below = take_digits(rest, 10);
  if (below.empty() || !rest.empty()) return none(fault, "a rational is [+-]?[0-9]+/[0-9]+");
  const Integer denominator(below, 10);
  if (denominator == 0) return none(fault, "the denominator is zero");
  Rational value(Integer(whole, 10), denominator);
  value.canonicalize();
  return value;
}

}  // namespace

bool read_number(std::string_view token, Rational& value, std::string_view& fault) {
  const bool minus = take_minus(token);
  if (!read_small(token, value)) {
    std::optional<Rational> other = parse_magnitude(token, fault);
    if (!other) return false;
    value = *std::move(other);
  }
  if (minus) mpq_neg(value.get_mpq_t(), value.get_mpq_t());
  return true;
}

Rational parse_number(std::string_view token) {
  std::string_view fault;
  Rational value;
  if (read_number(token, value, fault)) return value;
  throw std::invalid_argument(std::string(fault));
}

}  // namespace flatdt::checker
