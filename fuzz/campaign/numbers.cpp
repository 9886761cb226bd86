#include "numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "options.hpp"

namespace flatdt::campaign {
namespace {

constexpr std::size_t kMostPlaces = 40;
constexpr double kYear = 366.0 * 24 * 3600;

std::size_t digits_at(const std::string& text, std::size_t from) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789", from), text.size());
  return end - std::min(from, end);
}

/// The length of the amount that the text begins with; 0 if there is none.
std::size_t amount_length(const std::string& text) {
  const std::size_t whole = digits_at(text, 0);
  if (whole == 0 || whole > kMostPlaces) return 0;
  if (whole == text.size() || text[whole] != '.') return whole;
  const std::size_t fraction = digits_at(text, whole + 1);
  return fraction == 0 || fraction > kMostPlaces ? 0 : whole + 1 + fraction;
}

}  // namespace

std::uint64_t whole_number(const std::string& text, const std::string& what, std::uint64_t least,
                           std::uint64_t most) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < least || value > most)
    throw UsageError(what + " must be a whole number from " + std::to_string(least) + " to " +
                     std::to_string(most) + ", not \"" + text + "\"");
  return value;
}

double amount(const std::string& text, const std::string& what, double most) {
  // The grammar is looked at first: strtod knows nan, inf, signs, exponents and hexadecimal digits.
  const bool valid = !text.empty() && amount_length(text) == text.size();
  const double value = valid ? std::strtod(text.c_str(), nullptr) : 0;
  if (!valid || value > most)
    throw UsageError(what + " must be a number from 0 to " +
                     std::to_string(static_cast<std::uint64_t>(most)) + ", not \"" + text + "\"");
  return value;
}

double parse_duration(const std::string& text) {
  const std::size_t length = amount_length(text);
  const std::string unit = text.substr(length);
  const double factor = unit.empty() || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
  const double seconds = factor * std::strtod(text.substr(0, length).c_str(), nullptr);
  if (length == 0 || factor == 0 || seconds > kYear)
    throw UsageError("a time is a number with s, m or h, at most a year, not \"" + text + "\"");
  return seconds;
}

}  // namespace flatdt::campaign
