// Hermite and Smith normal forms.
#include "lattice.hpp"

#include <gtest/gtest.h>

#include <random>

#include "flatdt/checker/errors.hpp"
#include "linear.hpp"
#include "smith.hpp"

namespace flatdt::checker {
namespace {

Vec<Rational> vec(const Rational& x, const Rational& y, const Rational& z = 0) {
  return {x, y, z};
}

TEST(Lattice, GrowsInRankAndIndex) {
  Lattice lattice(3);
  EXPECT_EQ(lattice.rank(), 0);
  EXPECT_TRUE(lattice.contains(vec(0, 0, 0)));
  lattice.insert(vec(2, 4, 6));
  lattice.insert(vec(3, 6, 9));
  EXPECT_EQ(lattice.rank(), 1);
  EXPECT_TRUE(lattice.contains(vec(1, 2, 3)));
  EXPECT_FALSE(lattice.contains(vec(Rational(1, 2), 1, Rational(3, 2))));
  lattice.insert(vec(0, Rational(1, 2), 0));
  lattice.insert(vec(0, 0, Rational(-1, 3)));
  EXPECT_EQ(lattice.rank(), 3);
  EXPECT_TRUE(lattice.contains(vec(-1, Rational(5, 2), Rational(2, 3))));
  EXPECT_FALSE(lattice.contains(vec(0, 0, Rational(1, 6))));
  EXPECT_EQ(abs(determinant(3, lattice.basis())), Rational(1, 6));
}

// A lattice equals the one of any other generating set, whatever the order; the determinant is checked
// against a unimodular recombination of a known basis.
TEST(Lattice, IndependentOfTheGenerators) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    const auto draw = [&] { return Rational(static_cast<long>(random() % 41) - 20, 1 + random() % 6); };
    Mat<Rational> basis;
    for (auto& row : basis) row = {draw(), draw(), draw()};
    for (auto& row : basis) {
      for (Rational& x : row) x.canonicalize();
    }
    Lattice direct(3);
    Lattice mixed(3);
    for (const auto& row : basis) direct.insert(row);
    for (int k = 0; k < 4; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        const long a = static_cast<long>(random() % 7) - 3;
        for (std::size_t c = 0; c < 3; ++c) basis[i][c] += a * basis[(i + 1) % 3][c];
      }
    }
    mixed.insert(add(basis[0], basis[1]));
    for (std::size_t i = 3; i-- > 0;) mixed.insert(basis[i]);
    EXPECT_EQ(direct.rank(), mixed.rank());
    for (const auto& row : basis) EXPECT_TRUE(direct.contains(row));
    if (direct.rank() < 3) continue;
    EXPECT_EQ(direct.basis(), mixed.basis());  // Hermite normal form is unique
  }
}

TEST(Lattice, ReduceIsCanonical) {
  Lattice lattice(2);
  lattice.insert(vec(3, 1));
  lattice.insert(vec(0, 5));
  for (long x = -20; x <= 20; ++x) {
    for (long y = -20; y <= 20; ++y) {
      Vec<Integer> v = {x, y, 0};
      lattice.reduce(v);
      EXPECT_TRUE(v[0] >= 0 && v[0] < 3 && v[1] >= 0 && v[1] < 5);
      EXPECT_TRUE(lattice.contains(vec(x - Rational(v[0]), y - Rational(v[1]))));
    }
  }
}

TEST(Lattice, RefusesHugeCommonDenominators) {
  Lattice lattice(2);
  Integer denominator = 1;
  EXPECT_THROW(
      for (unsigned long k = 1; k < 100'000; ++k) {
        denominator = (Integer(1) << 2000) + k;
        lattice.insert(vec(Rational(1, denominator), 0));
      },
      ResourceLimit);
}

TEST(Smith, KnownGroups) {
  EXPECT_EQ(to_string(abelian_group(2, {})), "Z^2");
  EXPECT_EQ(to_string(abelian_group(0, {})), "0");
  EXPECT_EQ(to_string(abelian_group(1, {{1}})), "0");
  EXPECT_EQ(to_string(abelian_group(2, {{2, 0}, {0, 3}})), "Z/6");
  EXPECT_EQ(to_string(abelian_group(2, {{4, 0}, {0, 6}})), "Z/2+Z/12");
  EXPECT_EQ(to_string(abelian_group(3, {{2, 4, 4}, {-6, 6, 12}, {10, -4, -16}})), "Z/2+Z/6+Z/12");
  EXPECT_EQ(to_string(abelian_group(3, {{2, -2, 0}, {2, -2, 0}})), "Z^2+Z/2");
}

// Row transformation: (first columns of the result) = U (original) up to column operations, with U
// unimodular.
TEST(Smith, AppendedIdentityBecomesTheRowTransformation) {
  Rows rows = {{2, 4, 1, 0}, {3, 7, 0, 1}};
  const std::vector<Integer> diagonal = diagonalise(rows, 2);
  EXPECT_EQ(Integer(diagonal[0] * diagonal[1]), 2);
  EXPECT_EQ(Integer(abs(rows[0][2] * rows[1][3] - rows[0][3] * rows[1][2])), 1);
  for (std::size_t i = 0; i < 2; ++i) {  // row i of U times the matrix is divisible by diagonal[i]
    for (std::size_t j = 0; j < 2; ++j) {
      const Integer entry = rows[i][2] * (j == 0 ? 2 : 4) + rows[i][3] * (j == 0 ? 3 : 7);
      EXPECT_EQ(Integer(entry % diagonal[i]), 0);
    }
  }
}

}  // namespace
}  // namespace flatdt::checker
