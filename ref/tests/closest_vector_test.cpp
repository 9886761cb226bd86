/// Closest and shortest vectors, Voronoi cell and covering radius, against exhaustion.
#include "flatdt/ref/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "lattice_samples.hpp"
#include "small_closest_vectors.hpp"

namespace flatdt::ref {
namespace {

using namespace samples;

/// All vectors of a box of coordinates that surely holds the closest ones, by exhaustion.
std::vector<Vector> closest_by_exhaustion(const Matrix& gram, const Vector& x, int bound) {
  std::vector<Vector> closest;
  Rational least;
  for (const Vector& s : box(gram.dimension(), bound)) {
    const Rational distance = squared_length(gram, x - s);
    if (closest.empty() || distance < least) {
      closest.clear();
      least = distance;
    }
    if (distance == least) closest.push_back(s);
  }
  std::sort(closest.begin(), closest.end());
  return closest;
}

std::vector<Vector> closest_in_machine_integers(const Matrix& gram, const Vector& x) {
  Integer common = 1;
  for (int i = 0; i < x.dimension(); ++i) common = lcm(common, x[i].denominator());
  SmallClosestVectors::Coordinates numerators{};
  for (int i = 0; i < x.dimension(); ++i)
    numerators[static_cast<std::size_t>(i)] = (Rational(common) * x[i]).numerator().to_long();
  const auto search = SmallClosestVectors::make(gram);
  if (!search) return {};
  const auto found = (*search)(numerators, common.to_long());
  std::vector<Vector> closest;
  for (const auto& s : found.value()) {
    closest.emplace_back(x.dimension());
    for (int i = 0; i < x.dimension(); ++i)
      closest.back()[i] = static_cast<long>(s[static_cast<std::size_t>(i)]);
  }
  std::sort(closest.begin(), closest.end());
  return closest;
}

TEST(ClosestVectors, FindsAllTies) {
  Random random(1);
  std::size_t most_ties = 0;
  for (int round = 0; round < 150; ++round) {
    const int d = uniform(random, 2, 3);
    // Reduced, so that the box of 4 around [-2,2]^d holds the closest vectors.
    const Matrix gram = reduce_basis(random_gram(random, d, uniform(random, 1, 2))).gram;
    const Vector x = random_vector(random, d, 4, uniform(random, 2, 4));
    const std::vector<Vector> expected = closest_by_exhaustion(gram, x, 4);
    ASSERT_EQ(closest_vectors(gram, x), expected) << gram.to_string() << " | " << x.to_string();
    most_ties = std::max(most_ties, expected.size());
    ASSERT_EQ(closest_in_machine_integers(gram, x), expected) << gram.to_string() << " | " << x.to_string();
    // The same lattice in a skew basis.
    const Matrix skew = random_unimodular(random, d, 8);
    std::vector<Vector> images;
    for (const Vector& s : expected) images.push_back(skew.inverse() * s);
    std::sort(images.begin(), images.end());
    ASSERT_EQ(closest_vectors(skew.transpose() * gram * skew, skew.inverse() * x), images);
  }
  EXPECT_EQ(most_ties, 8U);
}

TEST(ClosestVectors, OfTheCentreOfACubeAreItsCorners) {
  Vector centre(3);
  for (int i = 0; i < 3; ++i) centre[i] = Rational(Integer(7), Integer(2));
  const std::vector<Vector> corners = closest_vectors(Matrix::identity(3), centre);
  ASSERT_EQ(corners.size(), 8U);
  EXPECT_EQ(corners.front().to_string(), "3 3 3");
  EXPECT_EQ(corners.back().to_string(), "4 4 4");
}

TEST(ShortVectors, AreAllOfABall) {
  Random random(1);
  for (int round = 0; round < 60; ++round) {
    const int d = uniform(random, 2, 3);
    const Matrix gram = reduce_basis(random_gram(random, d, uniform(random, 1, 4))).gram;
    // Often attained: the ball is closed. The box of 5 holds twice the shortest length.
    const Rational bound = Rational(uniform(random, 1, 4)) * shortest_squared_length(gram);
    std::vector<Vector> expected;
    for (const Vector& v : box(d, 5))
      if (!v.is_zero() && squared_length(gram, v) <= bound) expected.push_back(v);
    std::vector<Vector> found = short_vectors(gram, bound);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(found.empty());
  }
  EXPECT_TRUE(short_vectors(Matrix::identity(3), Rational(0)).empty());
  EXPECT_TRUE(short_vectors(Matrix::identity(2), Rational(-1)).empty());
}

TEST(ShortestVector, AgreesWithExhaustion) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const int d = uniform(random, 2, 3);
    const Matrix gram = random_gram(random, d, uniform(random, 1, 9));
    const Matrix reduced = reduce_basis(gram).gram;
    Rational least = reduced(0, 0);
    for (const Vector& v : box(d, 3))
      if (!v.is_zero()) least = std::min(least, squared_length(reduced, v));
    EXPECT_EQ(shortest_squared_length(gram), least);
  }
}

TEST(VoronoiVectors, DecideMembershipInTheVoronoiCell) {
  Random random(1);
  for (int round = 0; round < 100; ++round) {
    const int d = uniform(random, 2, 3);
    const Matrix gram = random_gram(random, d, 4);
    const std::vector<Vector> relevant = voronoi_vectors(gram);
    EXPECT_EQ(relevant.size(), d == 2 ? 6U : 14U);
    for (int i = 0; i < 10; ++i) {
      const Vector x = random_vector(random, d, 8, 8);
      const bool inside = std::all_of(relevant.begin(), relevant.end(), [&](const Vector& n) {
        return Rational(2) * inner_product(gram, x, n) <= squared_length(gram, n);
      });
      const std::vector<Vector> closest = closest_vectors(gram, x);
      EXPECT_EQ(inside, std::find(closest.begin(), closest.end(), Vector(d)) != closest.end());
    }
  }
}

TEST(CoveringRadius, OfWellKnownLattices) {
  const auto ratio = [](int a, int b) { return Rational(Integer(a), Integer(b)); };
  EXPECT_EQ(covering_radius_squared(gram_of(2, {1, 0, 0, 100})), ratio(101, 4));
  EXPECT_EQ(covering_radius_squared(gram_of(2, {2, 1, 1, 2})), ratio(2, 3));                 // hexagonal
  EXPECT_EQ(covering_radius_squared(gram_of(3, {1, 0, 0, 0, 1, 0, 0, 0, 1})), ratio(3, 4));  // cubic
  EXPECT_EQ(covering_radius_squared(gram_of(3, {2, 1, 1, 1, 2, 1, 1, 1, 2})), Rational(1));  // fcc
  EXPECT_EQ(covering_radius_squared(gram_of(3, {3, -1, -1, -1, 3, -1, -1, -1, 3})), ratio(5, 4));  // bcc
  EXPECT_EQ(covering_radius_squared(gram_of(3, {2, 1, 0, 1, 2, 0, 0, 0, 5})), ratio(23, 12));
}

TEST(CoveringRadius, IsTheDeepestHoleOfTheLattice) {
  Random random(1);
  for (int round = 0; round < 20; ++round) {
    const int d = uniform(random, 2, 3);
    const Matrix gram = random_gram(random, d, 5);
    const Rational radius = covering_radius_squared(gram);
    // No point is further away, and some vertex of the Voronoi cell is as far: all of them are solutions of d
    // independent equations 2 <x,n> = <n,n>.
    Rational deepest;
    const std::vector<Vector> relevant = voronoi_vectors(gram);
    const auto try_hole = [&](const Matrix& rows, const Vector& right_side) {
      if (rows.determinant().is_zero()) return;
      const Vector x = rows.inverse() * right_side;
      for (const Vector& n : relevant)
        if (Rational(2) * inner_product(gram, x, n) > squared_length(gram, n)) return;
      deepest = std::max(deepest, squared_length(gram, x));
    };
    std::vector<std::size_t> chosen(static_cast<std::size_t>(d));
    for (std::size_t code = 0; code < (d == 2 ? 36U : 2744U); ++code) {
      Matrix rows(d);
      Vector right_side(d);
      std::size_t rest = code;
      bool increasing = true;
      for (int i = 0; i < d; ++i) {
        chosen[static_cast<std::size_t>(i)] = rest % relevant.size();
        rest /= relevant.size();
        increasing = increasing && (i == 0 || chosen[static_cast<std::size_t>(i)] >
                                                  chosen[static_cast<std::size_t>(i - 1)]);
        const Vector& n = relevant[chosen[static_cast<std::size_t>(i)]];
        const Vector row = Rational(2) * (gram * n);
        for (int j = 0; j < d; ++j) rows(i, j) = row[j];
        right_side[i] = squared_length(gram, n);
      }
      if (increasing) try_hole(rows, right_side);
    }
    EXPECT_EQ(deepest, radius) << gram.to_string();
  }
}

}  // namespace
}  // namespace flatdt::ref
