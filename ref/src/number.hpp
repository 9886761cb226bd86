/// NUMBER tokens and the exact numbers they stand for (FORMAT: lexical rules and limits). Nothing is rounded.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "flatdt/ref/isometry.hpp"

namespace flatdt::ref {

inline constexpr long kMaxDecimalExponent = 1100;
inline constexpr long kMaxBinaryExponent = 4400;

/// What is wrong with a token that must be a number.
enum class NumberFault : std::uint8_t { form, decimal_exponent, binary_exponent, zero_denominator };

/// "is not a number: ..." and the like: what follows the token in a message.
std::string text_of(NumberFault fault);

/// The value of a NUMBER token: rational, decimal or hexadecimal, letters in either case. Nothing if it is
/// none, and then `fault` is why.
std::optional<Rational> number_of(std::string_view token, NumberFault& fault);
/// The same. Errors: InvalidInput saying what is wrong, without a location.
Rational parse_number(std::string_view token);

/// Whether s is a digit or more.
bool is_digits(std::string_view s, int base);
/// The value of a string of decimal digits, or nothing if it exceeds maximum. Requires: maximum < 10^18.
std::optional<std::uint64_t> natural_up_to(std::string_view digits, std::uint64_t maximum);

/// The reduced rational "p" or "p/q". Errors: LimitReached if that is longer than a token may be (numbers
/// read from hexadecimal digits or with large exponents can be).
std::string number_token(const Rational& value);
/// The matrix [R|t] row by row, as Lexer::isometry reads it. Errors: as number_token.
std::string isometry_tokens(const Isometry& g);

}  // namespace flatdt::ref
