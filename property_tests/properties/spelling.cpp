#include "spelling.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "random.hpp"

namespace flatdt::property_tests {
namespace {

using testing::Random;

std::string gap(Random& random) {
  static const std::vector<std::string> kGaps{
      " ", "\n", "\t", "\r\n", "  \v", "\f", "#\n", " # 1/0 \xc3\xa9 ends here\n", "\n\n#one\n#two\n"};
  return random.of(kGaps);
}

/// The exponent e >= 0 with q = base^e, or -1.
long exact_power(mpz_class q, unsigned long base) {
  long e = 0;
  while (mpz_divisible_ui_p(q.get_mpz_t(), base) != 0) {
    q /= base;
    ++e;
  }
  return q == 1 ? e : -1;
}

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// digits (base 10 or 16, without sign) with a point before the last `places` of them.
std::string with_point(std::string digits, std::size_t places) {
  if (digits.size() < places) digits.insert(0, places - digits.size(), '0');
  digits.insert(digits.size() - places, ".");
  return digits;
}

/// x = p / 2^e: as p * 16^-places * 2^shift.
std::string hexadecimal(const mpz_class& p, long e, Random& random) {
  const std::size_t places = random.below(4);
  const long shift = 4 * static_cast<long>(places) - e;
  std::string text = "0x" + with_point(p.get_str(16), places);
  if (shift != 0 || random.one_in(2)) text += "p" + std::to_string(shift);
  return text;
}

/// x = p / (2^a 5^b): an exact decimal, sometimes with an exponent.
std::string decimal(const mpz_class& p, long a, long b, Random& random) {
  const auto places = static_cast<std::size_t>(std::max(a, b));
  mpz_class power, digits;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, places);
  mpz_class denominator, five;
  mpz_ui_pow_ui(denominator.get_mpz_t(), 2, static_cast<unsigned long>(a));
  mpz_ui_pow_ui(five.get_mpz_t(), 5, static_cast<unsigned long>(b));
  denominator *= five;
  digits = p * power / denominator;
  if (random.one_in(2)) return with_point(digits.get_str(), places);
  const std::size_t more = random.below(5);
  return with_point(digits.get_str(), places + more) + "e" + (random.one_in(2) ? "+" : "") +
         std::to_string(more);
}

std::string unreduced(const mpz_class& p, const mpz_class& q, Random& random) {
  const mpz_class factor(static_cast<unsigned long>(random.between(2, 1000)));
  const mpz_class numerator = p * factor, denominator = q * factor;
  return (random.one_in(3) ? "00" : "") + numerator.get_str() + "/" + denominator.get_str();
}

std::string respell_number(const std::string& token, Random& random) {
  mpq_class x(token);
  x.canonicalize();
  const mpz_class p = abs(x.get_num());
  const mpz_class q = x.get_den();
  std::string text = token[0] == '-' ? token.substr(1) : token;
  mpz_class odd = q;
  long twos = 0;
  while (mpz_divisible_ui_p(odd.get_mpz_t(), 2) != 0) {
    odd /= 2;
    ++twos;
  }
  const long fives = exact_power(odd, 5);
  switch (random.below(4)) {
    case 0:
      text = unreduced(p, q, random);
      break;
    case 1:
      if (fives >= 0) text = decimal(p, twos, fives, random);
      break;
    case 2:
      if (odd == 1) text = hexadecimal(p, twos, random);
      break;
    default:
      break;
  }
  if (random.one_in(2)) text = capitals(text);
  return (sgn(x) < 0 ? "-" : random.one_in(3) ? "+" : "") + text;
}

bool is_number(const std::string& token) {
  return token.find_first_not_of("+-0123456789/") == std::string::npos;
}

}  // namespace

std::string respell(const std::string& text, std::uint64_t seed) {
  Random random(seed);
  std::istringstream lines(text);
  std::string line, result;
  bool numbers = false;
  while (std::getline(lines, line)) {
    std::istringstream tokens(line.substr(0, line.find('#')));
    std::string token;
    for (bool first = true; tokens >> token; first = false) {
      // A line that begins with a keyword has counts and names behind it, but for the metric; cells are pairs
      // of indices. Neither may be spelled as a fraction.
      if (first && !is_number(token)) numbers = token != "cells";
      const bool keyword_line =
          !is_number(line.substr(0, line.find(' '))) && line.rfind("metric", 0) != 0 && line[0] != ' ';
      result += numbers && !keyword_line && is_number(token) ? respell_number(token, random) : token;
      result += gap(random);
    }
  }
  return result;
}

}  // namespace flatdt::property_tests
