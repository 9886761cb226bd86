#include "number.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "flatdt/ref/errors.hpp"
#include "lexer.hpp"

namespace flatdt::ref {
namespace {

bool is_digit(char c, int base) {
  const auto lower = static_cast<char>(c | 0x20);
  return (c >= '0' && c <= '9') || (base == 16 && lower >= 'a' && lower <= 'f');
}

}  // namespace

bool is_digits(std::string_view s, int base) {
  return !s.empty() && std::all_of(s.begin(), s.end(), [base](char c) { return is_digit(c, base); });
}

std::optional<std::uint64_t> natural_up_to(std::string_view digits, std::uint64_t maximum) {
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  if (digits.size() > 18) return std::nullopt;
  std::uint64_t value = 0;
  for (const char c : digits) value = 10 * value + static_cast<std::uint64_t>(c - '0');
  if (value > maximum) return std::nullopt;
  return value;
}

namespace {

Integer from_digits(const std::string& digits, int base) {
  return Integer(mpz_class(digits, base));
}

Integer power(unsigned long base, unsigned long exponent) {
  mpz_class p;
  mpz_ui_pow_ui(p.get_mpz_t(), base, exponent);
  return Integer(p);
}

/// value * radix^exponent.
Rational scaled(const Rational& value, unsigned long radix, long exponent) {
  if (exponent == 0) return value;
  const Integer factor = power(radix, static_cast<unsigned long>(std::abs(exponent)));
  return exponent > 0 ? value * Rational(factor) : value / Rational(factor);
}

/// Digits of `base` with at most one point, then optionally a letter and a power of `radix`. Nothing if they
/// are not, and then `fault` is why; so in all functions below.
std::optional<Rational> positional(std::string_view body, int base, char letter, unsigned long radix,
                                   NumberFault& fault) {
  fault = NumberFault::form;
  const auto is_letter = [letter](char c) { return static_cast<char>(c | 0x20) == letter; };
  const auto mark =
      static_cast<std::size_t>(std::find_if(body.begin(), body.end(), is_letter) - body.begin());
  const std::string_view mantissa = body.substr(0, mark);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  std::string digits(mantissa.substr(0, point));
  std::size_t places = 0;
  if (point < mantissa.size()) {
    places = mantissa.size() - point - 1;
    digits += mantissa.substr(point + 1);
  }
  if (!is_digits(digits, base)) return std::nullopt;
  Rational value(from_digits(digits, base), power(static_cast<unsigned long>(base), places));
  if (mark == body.size()) return value;

  std::string_view exponent = body.substr(mark + 1);
  const bool negative = !exponent.empty() && exponent[0] == '-';
  if (!exponent.empty() && (exponent[0] == '-' || exponent[0] == '+')) exponent.remove_prefix(1);
  if (!is_digits(exponent, 10)) return std::nullopt;
  const long most = radix == 2 ? kMaxBinaryExponent : kMaxDecimalExponent;
  const auto size = natural_up_to(exponent, static_cast<std::uint64_t>(most));
  if (!size) {
    fault = radix == 2 ? NumberFault::binary_exponent : NumberFault::decimal_exponent;
    return std::nullopt;
  }
  const auto magnitude = static_cast<long>(*size);
  return scaled(value, radix, negative ? -magnitude : magnitude);
}

/// The most frequent tokens, integers and fractions of at most 18 digits each: without strings and large
/// integers. Nothing for all others, wrong ones too.
std::optional<Rational> short_fraction(std::string_view body) {
  const std::size_t slash = std::min(body.find('/'), body.size());
  const std::string_view above = body.substr(0, slash);
  const std::string_view below = slash < body.size() ? body.substr(slash + 1) : "1";
  const auto parsed = [](std::string_view digits, std::int64_t& value) {
    constexpr std::size_t kMostDigits = 18;  // 10^18 < 2^63
    return !digits.empty() && digits.size() <= kMostDigits && is_digit(digits[0], 10) &&
           std::from_chars(digits.data(), digits.data() + digits.size(), value).ptr ==
               digits.data() + digits.size();
  };
  std::int64_t numerator = 0, denominator = 0;
  if (!parsed(above, numerator) || !parsed(below, denominator) || denominator == 0) return std::nullopt;
  return Rational::ratio(numerator, denominator);
}

std::optional<Rational> fraction(std::string_view body, std::size_t slash, NumberFault& fault) {
  const std::string_view above = body.substr(0, slash), below = body.substr(slash + 1);
  fault = NumberFault::form;
  if (!is_digits(above, 10) || !is_digits(below, 10)) return std::nullopt;
  const Integer denominator = from_digits(std::string(below), 10);
  fault = NumberFault::zero_denominator;
  if (denominator.is_zero()) return std::nullopt;
  return Rational(from_digits(std::string(above), 10), denominator);
}

}  // namespace

std::string text_of(NumberFault fault) {
  const auto beyond = [](long most) {
    return "has an exponent beyond the limit: at most " + std::to_string(most) + " in absolute value";
  };
  switch (fault) {
    case NumberFault::form:
      return "is not a number: write a number like 3/4, -0.75, 75e-2 or 0x1.8p-1";
    case NumberFault::decimal_exponent:
      return beyond(kMaxDecimalExponent);
    case NumberFault::binary_exponent:
      return beyond(kMaxBinaryExponent);
    case NumberFault::zero_denominator:
      return "has denominator 0: a denominator must not be zero";
  }
  throw InternalError("every fault of a number has a text");
}

std::optional<Rational> number_of(std::string_view token, NumberFault& fault) {
  std::string_view body = token;
  const bool negative = !body.empty() && body[0] == '-';
  if (!body.empty() && (body[0] == '-' || body[0] == '+')) body.remove_prefix(1);
  std::optional<Rational> value = short_fraction(body);
  if (value) return negative ? -*value : *std::move(value);
  if (body.size() >= 2 && body[0] == '0' && (body[1] == 'x' || body[1] == 'X')) {
    value = positional(body.substr(2), 16, 'p', 2, fault);
  } else if (const std::size_t slash = body.find('/'); slash != std::string_view::npos) {
    value = fraction(body, slash, fault);
  } else {
    value = positional(body, 10, 'e', 10, fault);
  }
  if (value && negative) value = -*value;
  return value;
}

Rational parse_number(std::string_view token) {
  NumberFault fault{};
  if (std::optional<Rational> value = number_of(token, fault)) return *std::move(value);
  throw InvalidInput(text_of(fault));
}

std::string number_token(const Rational& value) {
  std::string token = value.to_string();
  if (token.size() > kMaxTokenBytes)
    throw LimitReached("a number to be written has " + std::to_string(token.size()) +
                       " bytes as a reduced rational, more than the " + std::to_string(kMaxTokenBytes) +
                       " bytes of a token");
  return token;
}

std::string isometry_tokens(const Isometry& g) {
  std::string text;
  for (int i = 0; i < g.dimension(); ++i) {
    for (int j = 0; j < g.dimension(); ++j) text += (i + j > 0 ? " " : "") + number_token(g.linear(i, j));
    text += " " + number_token(g.translation[i]);
  }
  return text;
}

}  // namespace flatdt::ref
