/// Decimals and unit cells. Cosines and square roots are computed in integers, so the result is the same on
/// every machine; libm differs between machines in the last place.
#include <algorithm>

#include "crystal.hpp"
#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::cli {
namespace {

constexpr std::size_t kMaxDecimalBytes = 64;
constexpr int kMaxExponent = 30;
constexpr int kWorkingDigits = 60;
constexpr int kMetricDigits = 6;
constexpr int kMatrixDigits = 15;

bool all_digits(std::string_view s) {
  return std::all_of(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; });
}

Rational power_of_ten(int exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent >= 0 ? Rational(Integer(power)) : Rational(Integer(1), Integer(power));
}

/// cos of an angle in degrees, with an error below 10^-50.
/// Law: exact at 60, 90 and 120, the only rational cosines in (0, 180) (Niven's theorem).
Rational cosine(const Rational& degrees) {
  if (degrees > Rational(90)) return -cosine(Rational(180) - degrees);
  if (degrees == Rational(90)) return 0;
  if (degrees == Rational(60)) return {Integer(1), Integer(2)};
  // pi to 79 decimals (OEIS A000796); the Taylor series alternates with terms that decrease from the second
  // on.
  const Rational pi = Rational(Integer("31415926535897932384626433832795028841971693993751"
                                       "058209749445923078164062862090")) *
                      power_of_ten(-79);
  const Rational angle = degrees * pi / Rational(180);
  const Rational square = rounded(angle * angle, kWorkingDigits);
  Rational sum(1), term(1);
  for (int k = 1; !term.is_zero(); k += 2) {
    term = rounded(-(term * square) / Rational(k * (k + 1)), kWorkingDigits);
    sum += term;
  }
  return sum;
}

/// The square root rounded down to kWorkingDigits decimals; zero for a value that only rounding made
/// negative.
Rational square_root(const Rational& value) {
  if (value.sign() == Sign::negative) return 0;
  const Integer scaled = floor(value * power_of_ten(2 * kWorkingDigits));
  mpz_class root;
  mpz_sqrt(root.get_mpz_t(), scaled.mpz().get_mpz_t());
  return Rational(Integer(root)) * power_of_ten(-kWorkingDigits);
}

struct Cell {
  std::array<Rational, 3> length, cosine;  // cosines of alpha, beta, gamma
};

[[noreturn]] void refuse_angles(const std::array<std::string, 6>& text) {
  throw InvalidInput("no cell has the angles " + text[3] + ", " + text[4] + ", " + text[5] + " degrees");
}

/// Law: three angles between 0 and 180 degrees are those between the edges of a cell that is not flat iff
/// each is less than the sum of the others and all are less than 360 together (the sides of a spherical
/// triangle). In degrees, exactly: the rounded Gram matrix of a flat cell may be positive definite.
bool are_angles_of_a_cell(const std::array<Rational, 3>& degrees) {
  const auto& [alpha, beta, gamma] = degrees;
  return alpha < beta + gamma && beta < gamma + alpha && gamma < alpha + beta &&
         alpha + beta + gamma < Rational(360);
}

Cell read_cell(const std::array<std::string, 6>& text) {
  static const std::array<const char*, 6> kNames = {"a", "b", "c", "alpha", "beta", "gamma"};
  Cell cell;
  std::array<Rational, 3> degrees;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string what = std::string("cell parameter ") + kNames[i];
    const Rational value = exact_decimal(text[i], what);
    if (i < 3) {
      if (value < power_of_ten(-3) || value > power_of_ten(6))
        throw InvalidInput(what + " is " + text[i] + ": a cell length must be 10^-3 to 10^6 Angstrom");
      cell.length[i] = value;
    } else {
      if (value.sign() != Sign::positive || value >= Rational(180))
        throw InvalidInput(what + " is " + text[i] + ": an angle must be between 0 and 180 degrees");
      degrees[i - 3] = value;
      cell.cosine[i - 3] = cosine(value);
    }
  }
  if (!are_angles_of_a_cell(degrees)) refuse_angles(text);
  return cell;
}

}  // namespace

Rational exact_decimal(std::string_view text, const std::string& what) {
  const auto fail = [&]() -> Rational {
    throw InvalidInput(what + ": \"" + std::string(text.substr(0, 40)) + "\" is not a number");
  };
  std::string_view body = text;
  if (body.size() > kMaxDecimalBytes) return fail();
  if (!body.empty() && body.back() == ')') {
    const std::size_t open = body.find('(');
    if (open == std::string_view::npos || !all_digits(body.substr(open + 1, body.size() - open - 2)))
      return fail();
    body = body.substr(0, open);
  }
  const bool negative = !body.empty() && body[0] == '-';
  if (!body.empty() && (body[0] == '-' || body[0] == '+')) body.remove_prefix(1);
  int exponent = 0;
  if (const std::size_t mark = body.find_first_of("eE"); mark != std::string_view::npos) {
    std::string_view digits = body.substr(mark + 1);
    const bool down = !digits.empty() && digits[0] == '-';
    if (!digits.empty() && (digits[0] == '-' || digits[0] == '+')) digits.remove_prefix(1);
    if (digits.empty() || digits.size() > 2 || !all_digits(digits)) return fail();
    exponent = std::stoi(std::string(digits)) * (down ? -1 : 1);
    if (std::abs(exponent) > kMaxExponent) return fail();
    body = body.substr(0, mark);
  }
  std::string digits(body.substr(0, body.find('.')));
  if (const std::size_t point = body.find('.'); point != std::string_view::npos) {
    digits += body.substr(point + 1);
    exponent -= static_cast<int>(body.size() - point - 1);
  }
  if (digits.empty() || !all_digits(digits)) return fail();
  const Rational value = Rational(Integer(digits)) * power_of_ten(exponent);
  return negative ? -value : value;
}

Rational rounded(const Rational& value, int digits) {
  return Rational(round_half_up(value * power_of_ten(digits))) * power_of_ten(-digits);
}

Matrix cell_metric(const std::array<std::string, 6>& text) {
  const Cell cell = read_cell(text);
  Matrix gram(3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational& cosine_ij = cell.cosine[3 - i - j];  // alpha is between b and c, and so on
      const Rational product = cell.length[i] * cell.length[j] * cosine_ij;
      const bool exact = (Rational(2) * cosine_ij).is_integer();
      const Rational entry = exact ? product : rounded(product, kMetricDigits);
      gram(static_cast<int>(i), static_cast<int>(j)) = entry;
      gram(static_cast<int>(j), static_cast<int>(i)) = entry;
    }
    gram(static_cast<int>(i), static_cast<int>(i)) = cell.length[i] * cell.length[i];
  }
  if (!is_positive_definite(gram)) refuse_angles(text);
  return gram;
}

Isometry cell_fractionalisation(const std::array<std::string, 6>& text) {
  const Cell cell = read_cell(text);
  const auto& [a, b, c] = cell.length;
  const auto& [cos_alpha, cos_beta, cos_gamma] = cell.cosine;
  const Rational one(1);
  const Rational sin_gamma = square_root(one - cos_gamma * cos_gamma);  // cosines are good to 10^-50
  // The volume of a cell with unit edges.
  const Rational volume = square_root(one - cos_alpha * cos_alpha - cos_beta * cos_beta -
                                      cos_gamma * cos_gamma + Rational(2) * cos_alpha * cos_beta * cos_gamma);
  if (sin_gamma.is_zero() || volume.is_zero()) throw InvalidInput("the cell is flat");
  // The inverse of the upper triangular matrix whose columns are the cell vectors.
  Matrix m(3);
  m(0, 0) = one / a;
  m(0, 1) = -cos_gamma / (a * sin_gamma);
  m(0, 2) = (cos_alpha * cos_gamma - cos_beta) / (a * volume * sin_gamma);
  m(1, 1) = one / (b * sin_gamma);
  m(1, 2) = (cos_beta * cos_gamma - cos_alpha) / (b * volume * sin_gamma);
  m(2, 2) = sin_gamma / (c * volume);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = rounded(m(i, j), kMatrixDigits);
  return {m, Vector(3)};
}

}  // namespace flatdt::ref::cli
