/// Laws of the normal forms and of reduction, on random lattices and on the skewest ones a file can hold.
#include "flatdt/ref/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "flatdt/ref/errors.hpp"
#include "lattice_samples.hpp"

namespace flatdt::ref {
namespace {

using namespace samples;

TEST(HermiteBasis, DependsOnTheLatticeOnly) {
  Random random(1);
  for (int round = 0; round < 500; ++round) {
    const int d = uniform(random, 1, 3);
    HermiteBasis a(d), b(d);
    std::vector<Vector> generators;
    for (int i = uniform(random, 0, 4); i > 0; --i)
      generators.push_back(random_vector(random, d, 6, uniform(random, 1, 4)));
    for (const Vector& g : generators) a.add(g);
    // Other generators of the same lattice: in another order, and changed by unimodular steps.
    for (std::size_t i = 0; i + 1 < generators.size(); ++i)
      generators[i] = generators[i] - Rational(uniform(random, -5, 5)) * generators[i + 1];
    std::reverse(generators.begin(), generators.end());
    for (const Vector& g : generators) b.add(g);
    ASSERT_EQ(a.vectors(), b.vectors());
    for (const Vector& g : generators) EXPECT_TRUE(a.contains(g));
  }
}

TEST(HermiteBasis, IsALowerEchelonFormWithReducedEntries) {
  Random random(1);
  for (int round = 0; round < 300; ++round) {
    HermiteBasis basis(3);
    for (int i = 0; i < 4; ++i) basis.add(random_vector(random, 3, 9, uniform(random, 1, 6)));
    int last_row = -1;
    for (std::size_t j = 0; j < basis.vectors().size(); ++j) {
      const Vector& v = basis.vectors()[j];
      int row = 0;
      while (v[row].is_zero()) ++row;
      EXPECT_GT(row, last_row);
      EXPECT_GT(v[row], Rational(0));
      for (std::size_t i = 0; i < j; ++i) {
        EXPECT_GE(basis.vectors()[i][row], Rational(0));
        EXPECT_LT(basis.vectors()[i][row], v[row]);
      }
      last_row = row;
    }
  }
}

TEST(HermiteBasis, HandlesRankBelowDimension) {
  HermiteBasis basis(3);
  EXPECT_EQ(basis.rank(), 0);
  EXPECT_TRUE(basis.contains(Vector(3)));
  Vector v(3), w(3);
  v[1] = Rational(Integer(1), Integer(2));
  v[2] = 3;
  w[1] = Rational(Integer(1), Integer(3));
  w[2] = 2;
  basis.add(v);
  basis.add(w);  // 2 v - 3 w = 0 in row 1 and in row 2: the same line
  EXPECT_EQ(basis.rank(), 1);
  EXPECT_EQ(basis.vectors()[0].to_string(), "0 1/6 1");
  EXPECT_TRUE(basis.contains(v + w));
  w[2] = 1;
  EXPECT_FALSE(basis.contains(w));
  w[0] = 1;
  EXPECT_FALSE(basis.contains(w));
}

TEST(HermiteBasis, RefusesHostileDenominators) {
  HermiteBasis basis(2);
  Vector v(2);
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 3, 25000);  // 39,625 bits
  v[0] = Rational(Integer(1), Integer(power));
  basis.add(v);
  mpz_ui_pow_ui(power.get_mpz_t(), 5, 25000);  // 58,049 bits: each passes, the common denominator does not
  v[0] = Rational(Integer(1), Integer(power));
  EXPECT_THROW(basis.add(v), LimitReached);
}

IntegerMatrix product(const IntegerMatrix& a, const IntegerMatrix& b, std::size_t columns) {
  IntegerMatrix m(a.size(), std::vector<Integer>(columns));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < columns; ++j)
      for (std::size_t k = 0; k < b.size(); ++k) m[i][j] += a[i][k] * b[k][j];
  return m;
}

/// By expansion along the first row.
Integer determinant(const IntegerMatrix& a) {
  if (a.empty()) return 1;
  Integer sum;
  for (std::size_t j = 0; j < a.size(); ++j) {
    IntegerMatrix minor(a.begin() + 1, a.end());
    for (auto& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
    sum += Integer(j % 2 == 0 ? 1 : -1) * a[0][j] * determinant(minor);
  }
  return sum;
}

TEST(SmithNormalForm, SatisfiesItsEquation) {
  Random random(1);
  for (int round = 0; round < 400; ++round) {
    const auto rows = static_cast<std::size_t>(uniform(random, 0, 5));
    const auto columns = rows == 0 ? 0 : static_cast<std::size_t>(uniform(random, 0, 5));
    const int range = round % 4 == 0 ? 0 : uniform(random, 1, 40);  // zero matrices too
    IntegerMatrix a(rows, std::vector<Integer>(columns));
    for (auto& row : a)
      for (Integer& entry : row) entry = uniform(random, -range, range);
    if (rows > 1 && round % 3 == 0) a[1] = a[0];  // rank-deficient
    const SmithForm form = smith_normal_form(a);
    ASSERT_EQ(product(product(form.left, a, columns), form.right, columns), form.diagonal);
    EXPECT_EQ(abs(determinant(form.left)), Integer(1));
    EXPECT_EQ(abs(determinant(form.right)), Integer(1));
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const Integer& entry = form.diagonal[i][j];
        if (i != j) {
          EXPECT_TRUE(entry.is_zero());
        } else {
          EXPECT_GE(entry, Integer(0));
          if (i > 0 && form.diagonal[i - 1][i - 1].is_zero()) {
            EXPECT_TRUE(entry.is_zero());
          }
          if (i > 0 && !form.diagonal[i - 1][i - 1].is_zero()) {
            EXPECT_TRUE(floor_mod(entry, form.diagonal[i - 1][i - 1]).is_zero());
          }
        }
      }
    }
  }
}

void expect_reduced(const Matrix& gram, const ReducedBasis& reduced) {
  const int d = gram.dimension();
  EXPECT_TRUE(reduced.transform.is_integral());
  EXPECT_EQ(abs(reduced.transform.determinant()), Rational(1));
  ASSERT_EQ(reduced.gram, reduced.transform.transpose() * gram * reduced.transform);
  for (int i = 0; i < d; ++i) {
    Rational row_sum;  // minus the product with v_0 = -(v_1 + .. + v_d)
    for (int j = 0; j < d; ++j) {
      if (i != j) {
        EXPECT_LE(reduced.gram(i, j), Rational(0));
      }
      row_sum += reduced.gram(i, j);
    }
    EXPECT_GE(row_sum, Rational(0));
    if (i > 0) {
      EXPECT_GE(reduced.gram(i, i), reduced.gram(i - 1, i - 1));
    }
  }
}

TEST(ReduceBasis, GivesAnObtuseSuperbaseOrderedByLength) {
  Random random(1);
  for (int round = 0; round < 600; ++round) {
    const int d = uniform(random, 2, 3);
    const Matrix skew = random_unimodular(random, d, uniform(random, 0, 12));
    const Matrix gram = skew.transpose() * random_gram(random, d, uniform(random, 1, 8)) * skew;
    expect_reduced(gram, reduce_basis(gram));
  }
}

TEST(ReduceBasis, IsLogarithmicInTheSkewness) {
  mpz_class huge;
  mpz_ui_pow_ui(huge.get_mpz_t(), 10, 300);
  const Rational big{Integer(huge)};
  for (int d = 2; d <= 3; ++d) {
    Matrix skew = Matrix::identity(d);
    skew(0, 1) = big;
    if (d == 3) {
      skew(0, 2) = big * big + Rational(1);
      skew(1, 2) = Rational(7) / Rational(3) * (big - Rational(1));  // 10^300 - 1 is divisible by 3
    }
    const Matrix gram = skew.transpose() * skew;
    const ReducedBasis reduced = reduce_basis(gram);
    expect_reduced(gram, reduced);
    EXPECT_TRUE(reduced.gram.is_identity());
  }
}

}  // namespace
}  // namespace flatdt::ref
