// The two stages of the insphere test: the filter is certain or silent, on inputs built to sit on the
// boundary.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "build.hpp"
#include "geometry.hpp"
#include "linear.hpp"

namespace flatdt::checker::test {
namespace {

/// The machinery for one instance whose points are the vertices of its cells, in the trivial frame.
struct Fixture {
  explicit Fixture(const std::string& instance_text)
      : instance(read_instance(instance_text)),
        group(make_group(
            std::get<Crystal>(close_group(instance.dimension, instance.generators, &instance.metric)))),
        table(group),
        subgroup(std::get<Subgroup>(Subgroup::make(group, nullptr))),
        orbits(make_orbits(instance, table)),
        complex(make_complex(triangulation(), {kIdentity}, orbits, subgroup, table)),
        geometry(complex, orbits, table, instance.metric) {}

  [[nodiscard]] Triangulation triangulation() const {
    Triangulation t;
    t.dimension = instance.dimension;
    const auto n = static_cast<std::uint32_t>(instance.points.size());
    for (std::uint32_t i = 0; i < n; ++i)
      t.cells.push_back({{{i, 0}, {(i + 1) % n, 0}, {(i + 2) % n, 0}, {(i + 3) % n, 0}}});
    return t;
  }

  Instance instance;
  Group group;
  ElementTable table;
  Subgroup subgroup;
  Orbits orbits;
  Complex complex;
  Geometry geometry;
};

/// Insphere by rationals: the same formula, expanded along the last column.
Sign slow_insphere(const Fixture& f, const Cell& cell, VertexId v, ElementId offset) {
  const int d = f.group.dimension;
  const auto n = static_cast<std::size_t>(d);
  const Vec<Rational> q = f.geometry.point(v, offset);
  std::array<Vec<Rational>, 4> p;
  for (std::size_t k = 0; k <= n; ++k)
    p[k] = subtract(f.geometry.point(cell.vertex[k], f.complex.offsets(cell)[0][k]), q);
  const Mat<Rational> gram =
      multiply(d, transpose(f.group.basis), multiply(d, f.instance.metric, f.group.basis));
  Rational value = 0;
  Rational orientation = 0;
  for (std::size_t k = 0; k <= n; ++k) {
    Mat<Rational> rows;
    for (std::size_t i = 0, row = 0; i <= n; ++i) {
      if (i != k) rows[row++] = p[i];
    }
    const Rational minor = determinant(d, rows);
    const bool even = (k + n) % 2 == 0;
    value += (even ? minor : Rational(-minor)) * squared_norm(d, gram, p[k]);
    orientation += even ? minor : Rational(-minor);
  }
  // det of rows (p_i, 1) is (-1)^d det[p_1 - p_0 ..], so the two signs (-1)^d cancel.
  return orientation > 0 ? sign_of(value) : opposite(sign_of(value));
}

struct Tally {
  int decided = 0;
  int silent = 0;
  int zero = 0;
};

void compare(Fixture& f, Tally& tally, std::mt19937& random, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const Cell& cell = f.complex.cells[random() % f.complex.cells.size()];
    const Sign orientation = sign_of(f.geometry.determinant(cell).numerator);
    if (orientation == Sign::zero) continue;
    const VertexId v = make_id<VertexId>(random() % f.complex.vertices.size());
    Element e{static_cast<std::uint8_t>(random() % f.group.order()), {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.group.dimension); ++i) {
      e.shift[i] = static_cast<long>(random() % 3) - 1;
    }
    const ElementId offset = f.table.intern(e);
    const Sign exact = f.geometry.insphere_exact(cell, orientation, v, offset);
    EXPECT_EQ(exact, slow_insphere(f, cell, v, offset));
    EXPECT_EQ(exact, f.geometry.insphere(cell, orientation, v, offset));
    const std::optional<Sign> filtered = f.geometry.insphere_filter(cell, orientation, v, offset);
    tally.zero += exact == Sign::zero ? 1 : 0;
    (filtered ? tally.decided : tally.silent)++;
    EXPECT_EQ(filtered.value_or(exact), exact);
  }
}

TEST(Filter, AgreesOnGenericPoints) {
  std::mt19937 random(1);
  Tally tally;
  for (const char* name : {"dicosm", "hexacosm", "second-amphidicosm"}) {
    std::string text = std::string("flatdt-instance 1 dimension 3 manifold ") + name + " points 12 ";
    for (int i = 0; i < 36; ++i) text += std::to_string(random() % 100'003) + "/100003 ";
    Fixture f(text);
    compare(f, tally, random, 300);
  }
  EXPECT_GT(tally.decided, 10 * tally.silent);
}

TEST(Filter, AgreesOnNearlyCosphericalPoints) {
  std::mt19937 random(2);
  Tally tally;
  for (const char* epsilon : {"0", "1e-5", "1e-15", "1e-16", "1e-17", "1e-18", "1e-100", "1e-1000"}) {
    std::string text = "flatdt-instance 1 dimension 3 manifold tetracosm points 8 ";
    for (int i = 0; i < 8; ++i) {
      for (int k = 0; k < 3; ++k) {
        const Rational x =
            Rational((i >> k & 1) == 0 ? 1 : 3, 8) +
            (random() % 3 - Rational(1)) *
                read_instance(std::string("flatdt-instance 1 dimension 2 manifold torus points 1 0 ") +
                              epsilon + " ")
                    .points[0][1];
        text += x.get_str() + " ";
      }
    }
    Fixture f(text);
    compare(f, tally, random, 200);
    Fixture plane("flatdt-instance 1 dimension 2 manifold pg points 5 1/8 1/8 3/8 1/8 1/8 3/8 3/8 3/8 1/4 " +
                  std::string(epsilon) + " ");
    compare(plane, tally, random, 200);
  }
  EXPECT_GT(tally.zero, 20);
  EXPECT_GT(tally.silent, 50);
  EXPECT_GT(tally.decided, 50);
}

TEST(Filter, SilentOnOverflowAndUnderflow) {
  Tally tally;
  std::mt19937 random(3);
  for (const char* scale : {"1e300", "1e-300", "1e1000", "1e-1000"}) {
    Fixture f(std::string("flatdt-instance 1 dimension 3 manifold P1 metric ") + scale + " 0 0 " + scale +
              " 0 " + scale + " points 5 1/7 1/5 1/3 1/2 1/9 2/3 1/11 6/7 1/4 1/13 1/6 8/9 3/4 2/7 1/19 ");
    compare(f, tally, random, 100);
  }
  EXPECT_GT(tally.silent, 100);
}

// The bound itself: random expressions in balls contain the exact value.
TEST(Filter, BallsContainTheExactValue) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 2000; ++round) {
    Rational exact(uniform(random));
    exact /= 3;
    Ball ball = to_ball(exact);
    for (int step = 0; step < 12; ++step) {
      const Rational other = Rational(uniform(random)) / 7;
      const Ball b = to_ball(other);
      switch (random() % 4) {
        case 0:
          exact += other;
          ball = ball + b;
          break;
        case 1:
          exact -= other;
          ball = ball - b;
          break;
        case 2:
          exact *= other;
          ball = ball * b;
          break;
        default:
          exact *= exact;
          ball = ball * ball;
          break;
      }
    }
    ASSERT_TRUE(std::isfinite(ball.rad));
    EXPECT_LE(abs(Rational(ball.mid) - exact), Rational(ball.rad));
  }
  EXPECT_FALSE(
      certain_sign({std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(certain_sign({std::nan(""), 0}));
  EXPECT_FALSE(certain_sign({1, std::nan("")}));
  EXPECT_FALSE(certain_sign({0, 0}));
  EXPECT_EQ(certain_sign({1, 0.5}), Sign::positive);
  EXPECT_EQ(certain_sign({-1, 0.5}), Sign::negative);
  EXPECT_FALSE(certain_sign({1, 1}));
}

}  // namespace
}  // namespace flatdt::checker::test
