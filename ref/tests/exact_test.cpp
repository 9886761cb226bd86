/// Rationals in machine integers, against GMP's, around the bounds where one form gives way to the other.
#include "flatdt/ref/exact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace flatdt::ref {
namespace {

/// Fractions of numbers next to powers of two about 2^31, 2^62 and 2^63, of primes, and of a large number.
std::vector<mpq_class> values() {
  std::vector<mpz_class> numbers{0, 1, 2, 3, 97};
  for (const unsigned power : {31U, 32U, 62U, 63U, 64U}) {
    const mpz_class p = mpz_class(1) << power;
    numbers.insert(numbers.end(), {p - 1, p, p + 1});
  }
  numbers.emplace_back("1000000000000000000000000000057");
  std::vector<mpq_class> all;
  for (const mpz_class& numerator : numbers)
    for (const mpz_class& denominator : numbers) {
      if (denominator == 0) continue;
      mpq_class value(numerator, denominator);
      value.canonicalize();
      all.push_back(value);
      all.emplace_back(-value);
    }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// The value, and its form: small iff both numbers are below 2^63 in magnitude.
void expect_same(const Rational& ours, const mpq_class& theirs) {
  const mpz_class bound = mpz_class(1) << 63U;
  ASSERT_EQ(ours.mpq(), theirs);
  ASSERT_EQ(ours.is_small(), abs(theirs.get_num()) < bound && theirs.get_den() < bound) << theirs;
}

/// All pairs; with sanitizers, where they took 50 s, a quarter of them.
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t kStep = 4;
#else
constexpr std::size_t kStep = 1;
#endif

TEST(Rational, ComputesAsGmpDoesInBothForms) {
  const std::vector<mpq_class> all = values();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const mpq_class& a = all[i];
    const Rational x(a);
    expect_same(x, a);
    expect_same(-x, -a);
    expect_same(abs(x), abs(a));
    EXPECT_EQ(x.sign(), sign_of_int(sgn(a)));
    EXPECT_EQ(x.is_zero(), sgn(a) == 0);
    EXPECT_EQ(x.is_integer(), a.get_den() == 1);
    EXPECT_EQ(x.to_string(), a.get_str());
    EXPECT_EQ(x.to_double(), a.get_d());
    EXPECT_EQ(x.numerator().mpz(), a.get_num());
    EXPECT_EQ(x.denominator().mpz(), a.get_den());
    EXPECT_EQ(Rational(x.numerator(), x.denominator()), x);
    mpz_class below;
    mpz_fdiv_q(below.get_mpz_t(), a.get_num_mpz_t(), a.get_den_mpz_t());
    EXPECT_EQ(floor(x).mpz(), below);
    for (std::size_t j = i % kStep; j < all.size(); j += kStep) {
      const mpq_class& b = all[j];
      const Rational y(b);
      expect_same(x + y, a + b);
      expect_same(x - y, a - b);
      expect_same(x * y, a * b);
      if (sgn(b) != 0) expect_same(x / y, a / b);
      ASSERT_EQ(x < y, a < b);
      ASSERT_EQ(x == y, a == b);
      Rational z = x;
      z += y;
      z -= x;
      z *= y;
      expect_same(z, b * b);
      z = x;
      z.add_multiple(-97, y);
      expect_same(z, a - 97 * b);
    }
  }
}

TEST(Rational, IsCopiedAndMovedInBothForms) {
  const mpq_class large("123456789012345678901234567891/7"), small("-5/3");
  for (const auto& [a, b] : std::vector<std::pair<mpq_class, mpq_class>>{
           {large, small}, {small, large}, {large, large + 1}, {small, small + 1}}) {
    Rational x(a), y(b);
    const Rational copy = x;
    x = y;
    expect_same(x, b);
    expect_same(copy, a);
    x = std::move(y);
    expect_same(x, b);
    Rational z(std::move(x));
    expect_same(z, b);
    z = copy;
    expect_same(z, a);
    Rational& same = z;
    z = same;
    z = std::move(same);
    expect_same(z, a);
    z += z;
    expect_same(z, a + a);
    z -= z;
    expect_same(z, 0);
  }
  static_assert(sizeof(Rational) == 16, "two words: a million points in space are 56 MB");
}

TEST(Rational, IsMadeOfMachineIntegers) {
  expect_same(Rational::ratio(6, 4), mpq_class(3, 2));
  expect_same(Rational::ratio(0, 5), mpq_class(0));
  expect_same(Rational::ratio(-INT64_MAX, INT64_MAX), mpq_class(-1));
  expect_same(Rational(INT64_MIN), -(mpz_class(1) << 63U));
  expect_same(Rational(long{INT64_MIN} + 1), 1 - (mpz_class(1) << 63U));
  EXPECT_THROW(static_cast<void>(Rational(1) / Rational(0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(Rational(Integer(1), Integer(0))), std::invalid_argument);
}

}  // namespace
}  // namespace flatdt::ref
