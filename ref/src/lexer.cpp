#include "lexer.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref {
namespace {

// Not std::isspace and friends: those depend on the locale.
bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');  // tab, LF, VT, FF, CR
}

bool is_digit(char c, int base) {
  const auto lower = static_cast<char>(c | 0x20);
  return (c >= '0' && c <= '9') || (base == 16 && lower >= 'a' && lower <= 'f');
}

bool is_digits(std::string_view s, int base) {
  return !s.empty() && std::all_of(s.begin(), s.end(), [base](char c) { return is_digit(c, base); });
}

/// A token as it is shown in messages; tokens may be 4,096 bytes long.
std::string quoted(std::string_view token) {
  constexpr std::size_t kShown = 40;
  return '"' + std::string(token.substr(0, kShown)) + (token.size() > kShown ? "...\"" : "\"");
}

/// The value of a string of decimal digits, or nothing if it exceeds maximum. Requires: maximum < 10^18.
std::optional<std::uint64_t> natural_up_to(std::string_view digits, std::uint64_t maximum) {
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  if (digits.size() > 18) return std::nullopt;
  std::uint64_t value = 0;
  for (const char c : digits) value = 10 * value + static_cast<std::uint64_t>(c - '0');
  if (value > maximum) return std::nullopt;
  return value;
}

Integer from_digits(const std::string& digits, int base) {
  return Integer(mpz_class(digits, base));
}

Integer power(unsigned long base, unsigned long exponent) {
  mpz_class p;
  mpz_ui_pow_ui(p.get_mpz_t(), base, exponent);
  return Integer(p);
}

constexpr const char* kNumberForms = "write a number like 3/4, -0.75, 75e-2 or 0x1.8p-1";

/// value * radix^exponent.
Rational scaled(const Rational& value, unsigned long radix, long exponent) {
  if (exponent == 0) return value;
  const Integer factor = power(radix, static_cast<unsigned long>(std::abs(exponent)));
  return exponent > 0 ? value * Rational(factor) : value / Rational(factor);
}

/// Digits of `base` with at most one point, then optionally a letter and a power of `radix`.
Rational positional(std::string_view body, int base, char letter, unsigned long radix, long max_exponent) {
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
  if (!is_digits(digits, base)) throw InvalidInput(std::string("is not a number: ") + kNumberForms);
  Rational value(from_digits(digits, base), power(static_cast<unsigned long>(base), places));
  if (mark == body.size()) return value;

  std::string_view exponent = body.substr(mark + 1);
  const bool negative = !exponent.empty() && exponent[0] == '-';
  if (!exponent.empty() && (exponent[0] == '-' || exponent[0] == '+')) exponent.remove_prefix(1);
  if (!is_digits(exponent, 10)) throw InvalidInput(std::string("is not a number: ") + kNumberForms);
  const auto size = natural_up_to(exponent, static_cast<std::uint64_t>(max_exponent));
  if (!size)
    throw InvalidInput("has an exponent beyond the limit: at most " + std::to_string(max_exponent) +
                       " in absolute value");
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

Rational fraction(std::string_view body, std::size_t slash) {
  const std::string_view above = body.substr(0, slash), below = body.substr(slash + 1);
  if (!is_digits(above, 10) || !is_digits(below, 10))
    throw InvalidInput(std::string("is not a number: ") + kNumberForms);
  const Integer denominator = from_digits(std::string(below), 10);
  if (denominator.is_zero()) throw InvalidInput("has denominator 0: a denominator must not be zero");
  return {from_digits(std::string(above), 10), denominator};
}

}  // namespace

Rational parse_number(std::string_view token) {
  std::string_view body = token;
  const bool negative = !body.empty() && body[0] == '-';
  if (!body.empty() && (body[0] == '-' || body[0] == '+')) body.remove_prefix(1);
  Rational value;
  if (const std::optional<Rational> frequent = short_fraction(body)) {
    value = *frequent;
  } else if (body.size() >= 2 && body[0] == '0' && (body[1] == 'x' || body[1] == 'X')) {
    value = positional(body.substr(2), 16, 'p', 2, kMaxBinaryExponent);
  } else if (const std::size_t slash = body.find('/'); slash != std::string_view::npos) {
    value = fraction(body, slash);
  } else {
    value = positional(body, 10, 'e', 10, kMaxDecimalExponent);
  }
  return negative ? -value : value;
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

Lexer::Lexer(std::string_view text, std::string file_name) : text_(text), file_name_(std::move(file_name)) {}

void Lexer::fail(const std::string& reason) const {
  throw InvalidInput(file_name_ + ":" + std::to_string(token_line_) + ": " + reason);
}

void Lexer::advance() {
  looked_ = true;
  token_ = {};
  while (position_ < text_.size() && (is_space(text_[position_]) || text_[position_] == '#')) {
    if (text_[position_] == '#') {
      position_ = std::min(text_.find('\n', position_), text_.size());
    } else {
      if (text_[position_] == '\n') ++line_;
      ++position_;
    }
  }
  token_line_ = line_;
  const std::size_t start = position_;
  while (position_ < text_.size() && !is_space(text_[position_]) && text_[position_] != '#') {
    const auto byte = static_cast<unsigned char>(text_[position_]);
    if (byte < 0x21 || byte > 0x7E)
      fail("byte " + std::to_string(byte) +
           " outside a comment: only white space and printable ASCII are allowed");
    if (++position_ - start > kMaxTokenBytes)
      fail("a token is longer than the limit of " + std::to_string(kMaxTokenBytes) + " bytes");
  }
  token_ = text_.substr(start, position_ - start);
  if (!token_.empty() && position_ == text_.size())
    fail("the file ends directly after " + quoted(token_) +
         ", so it may have been cut short: end it with a line break");
}

std::string_view Lexer::peek() {
  if (!looked_) advance();
  return token_;
}

bool Lexer::accept(std::string_view keyword) {
  if (peek() != keyword) return false;
  looked_ = false;
  return true;
}

void Lexer::expect(std::string_view keyword) {
  if (accept(keyword)) return;
  fail((token_.empty() ? "the file ends" : quoted(token_) + " stands") + " where \"" + std::string(keyword) +
       "\" must stand");
}

std::string_view Lexer::word(std::string_view what) {
  if (peek().empty()) fail("the file ends where " + std::string(what) + " must stand");
  looked_ = false;
  return token_;
}

Rational Lexer::number(std::string_view what) {
  const std::string_view token = word(what);
  try {
    return parse_number(token);
  } catch (const InvalidInput& error) {
    fail(std::string(what) + ": " + quoted(token) + " " + error.what());
  }
}

std::uint64_t Lexer::natural(std::string_view what, std::uint64_t maximum, std::string_view limit) {
  const std::string_view token = word(what);
  if (!is_digits(token, 10))
    fail(std::string(what) + ": " + quoted(token) + " is not a number of digits 0 to 9 only");
  const auto value = natural_up_to(token, maximum);
  if (!value)
    fail(std::string(what) + ": " + quoted(token) + " is " + std::string(limit) + " " +
         std::to_string(maximum));
  return *value;
}

std::uint64_t Lexer::count(std::string_view what, std::uint64_t maximum) {
  return natural(what, maximum, "beyond the limit of");
}

std::uint64_t Lexer::index(std::string_view what, std::uint64_t bound) {
  if (bound == 0) fail(std::string(what) + ": there is nothing that an index could mean");
  return natural(what, bound - 1, "out of range: they are numbered from 0 to");
}

Isometry Lexer::isometry(int dimension, std::string_view what) {
  Isometry g{Matrix(dimension), Vector(dimension)};
  for (int i = 0; i < dimension; ++i) {
    for (int j = 0; j < dimension; ++j) g.linear(i, j) = number(what);
    g.translation[i] = number(what);
  }
  return g;
}

void Lexer::expect_end(std::string_view last) {
  if (!peek().empty()) fail(quoted(token_) + " stands after the last " + std::string(last));
}

}  // namespace flatdt::ref
