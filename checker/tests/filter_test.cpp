// The stages of the insphere test: each is certain or silent, on inputs built to sit on the boundary.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "build.hpp"
#include "geometry.hpp"
#include "linear.hpp"

namespace flatdt::checker::test {
namespace {

/// The machinery for one instance whose points are the vertices of its cells, in the trivial frame; once with
/// machine integers where they fit, once without.
struct Fixture {
  explicit Fixture(const std::string& instance_text)
      : instance(read_instance(instance_text)),
        group(make_group(
            std::get<Crystal>(close_group(instance.dimension, instance.generators, &instance.metric)))),
        table(group),
        subgroup(std::get<Subgroup>(Subgroup::make(group, nullptr))),
        orbits(make_orbits(instance, table)),
        complex(make_complex(triangulation(), {kIdentity}, orbits, subgroup, table)),
        offsets(make_offsets()),
        geometry(complex, orbits, table, instance.metric),
        general(complex, orbits, table, instance.metric, Stages{.filter = true, .fixed_width = false}) {}

  [[nodiscard]] Triangulation triangulation() const {
    Triangulation t;
    t.dimension = instance.dimension;
    const auto n = static_cast<std::uint32_t>(instance.points.size());
    for (std::uint32_t i = 0; i < n; ++i)
      t.cells.push_back({{{i, 0}, {(i + 1) % n, 0}, {(i + 2) % n, 0}, {(i + 3) % n, 0}}});
    return t;
  }

  /// All elements that move by at most one lattice vector in each direction.
  [[nodiscard]] std::vector<ElementId> make_offsets() {
    std::vector<ElementId> ids;
    for (std::size_t r = 0; r < group.order(); ++r) {
      for (int k = 0; k < (instance.dimension == 2 ? 9 : 27); ++k) {
        ids.push_back(table.intern({static_cast<std::uint8_t>(r),
                                    {k % 3 - 1, k / 3 % 3 - 1, instance.dimension == 2 ? 0 : k / 9 - 1}}));
      }
    }
    return ids;
  }

  Instance instance;
  Group group;
  ElementTable table;
  Subgroup subgroup;
  Orbits orbits;
  Complex complex;
  std::vector<ElementId> offsets;
  Geometry geometry;
  Geometry general;
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
  int fixed = 0;
};

Sign orientation_of(const Fixture& f, Geometry& geometry, const Cell& cell, Rational& volume) {
  VolumeSum sum = geometry.no_volume();
  const Sign sign = geometry.orientation(cell, sum);
  volume = sum.total();
  EXPECT_EQ(sign == Sign::zero, volume == 0) << f.instance.dimension;
  return sign;
}

/// All stages against rationals; the tally is of the floating-point stage that the input has.
void compare(Fixture& f, Tally& tally, std::mt19937& random, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const Cell& cell = f.complex.cells[random() % f.complex.cells.size()];
    Rational volume;
    Rational general_volume;
    const Sign orientation = orientation_of(f, f.geometry, cell, volume);
    EXPECT_EQ(orientation, orientation_of(f, f.general, cell, general_volume));
    EXPECT_EQ(volume, general_volume);
    if (orientation == Sign::zero) continue;
    const Lift q{make_id<VertexId>(random() % f.complex.vertices.size()),
                 f.offsets[random() % f.offsets.size()]};
    const Sign exact = slow_insphere(f, cell, q.vertex, q.offset);
    const std::array<Lift, 5> points = f.geometry.lifts(cell, 0, q);
    EXPECT_EQ(exact, f.geometry.insphere_exact(points, orientation));
    EXPECT_EQ(exact, f.general.insphere_exact(points, orientation));
    EXPECT_EQ(exact, f.geometry.insphere(cell, 0, orientation, q));
    EXPECT_EQ(exact, f.general.insphere(cell, 0, orientation, q));
    const std::optional<Sign> balls = f.general.insphere_balls(points, orientation);
    EXPECT_EQ(balls.value_or(exact), exact);
    std::optional<Sign> filtered = balls;
    const std::optional<FixedGeometry>& fixed = f.geometry.fixed();
    const std::optional<Sign> limbs =
        fixed ? fixed->insphere(points, orientation, FixedStage::limbs) : std::nullopt;
    if (limbs) {  // else a lift does not fit
      EXPECT_EQ(*limbs, exact);
      filtered = fixed->insphere(points, orientation, FixedStage::doubles);
      EXPECT_EQ(filtered.value_or(exact), exact);
      ++tally.fixed;
    }
    tally.zero += exact == Sign::zero ? 1 : 0;
    (filtered ? tally.decided : tally.silent)++;
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
  EXPECT_GT(tally.fixed, 300);
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
  EXPECT_GT(tally.fixed, 300);
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
