/// The degeneracy that each family claims is really there, on every manifold.
#include <set>

#include "families_fixture.hpp"

namespace flatdt::ref {
namespace {

Rational half_to(int k) {
  return {Integer(1), Integer(1L << k)};
}

/// The distance of every coordinate from the nearest integer is at most `bound`.
bool near_integral(const Vector& x, const Rational& bound) {
  for (int i = 0; i < x.dimension(); ++i)
    if (abs(x[i] - Rational(round_half_up(x[i]))) > bound) return false;
  return true;
}

int rank(std::vector<std::vector<Rational>> rows) {
  int rank = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t c = 0; c < columns; ++c) {
    std::size_t pivot = static_cast<std::size_t>(rank);
    while (pivot < rows.size() && rows[pivot][c].is_zero()) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[pivot], rows[static_cast<std::size_t>(rank)]);
    const std::vector<Rational> lead = rows[static_cast<std::size_t>(rank)];
    for (std::size_t r = static_cast<std::size_t>(rank) + 1; r < rows.size(); ++r) {
      const Rational factor = rows[r][c] / lead[c];
      for (std::size_t k = c; k < columns; ++k) rows[r][k] -= factor * lead[k];
    }
    ++rank;
  }
  return rank;
}

/// Rank of the points lifted to the paraboloid: at most d iff they lie on one sphere or hyperplane.
int lifted_rank(const Instance& instance) {
  std::vector<std::vector<Rational>> rows;
  for (const Vector& x : instance.points) {
    const Vector v = x - instance.points[0];
    std::vector<Rational> row;
    for (int i = 0; i < v.dimension(); ++i) row.push_back(v[i]);
    row.push_back(squared_length(instance.gram, v));
    rows.push_back(row);
  }
  return rank(rows);
}

/// Some element {R|t+l} with R != I of this determinant moves x by a vector that R fixes: x lies on its axis
/// or glide plane.
bool on_fixed_space(const std::vector<Isometry>& cosets, const Vector& x, Sign determinant) {
  const int d = x.dimension();
  for (const Isometry& g : cosets) {
    if (g.linear.is_identity() || g.linear.determinant().sign() != determinant) continue;
    const Matrix moved = g.linear - Matrix::identity(d);
    for (int code = 0; code < 125; ++code) {
      Vector l(d);
      for (int i = 0, rest = code; i < d; ++i, rest /= 5) l[i] = rest % 5 - 2;
      if ((moved * (g * x + l - x)).is_zero()) return true;
    }
  }
  return false;
}

TEST_P(EveryManifold, UniformCoordinatesAreShortDyadics) {
  for (const Vector& x : make("uniform", 20).points) EXPECT_TRUE((Rational(1L << 20) * x).is_integral());
}

TEST_P(EveryManifold, LatticeOnATorusIsALattice) {
  if (entry().holonomy_order != 1) return;
  const Instance instance = make("lattice", 12);
  for (const Vector& x : instance.points)
    for (const Vector& y : instance.points)
      EXPECT_TRUE(std::any_of(instance.points.begin(), instance.points.end(),
                              [&](const Vector& z) { return (x - y - z).is_integral(); }));
}

TEST_P(EveryManifold, GridIsCoarse) {
  const int d = entry().dimension;
  long m = 1;
  while ((d == 2 ? m * m : m * m * m) < 20 * entry().holonomy_order) ++m;
  for (const Vector& x : make("grid", 20).points) EXPECT_TRUE((Rational(m) * x).is_integral());
}

TEST_P(EveryManifold, OnAxisLiesOnAxes) {
  for (const Vector& x : make("on-axis", 12).points) {
    if (has(Sign::positive)) {
      EXPECT_TRUE(on_fixed_space(cosets(), x, Sign::positive));
    } else if (has(Sign::negative)) {
      EXPECT_TRUE(on_fixed_space(cosets(), x, Sign::negative));
    } else {
      int nonzero = 0;
      for (int i = 0; i < x.dimension(); ++i) nonzero += x[i].is_zero() ? 0 : 1;
      EXPECT_LE(nonzero, 1);
    }
  }
}

TEST_P(EveryManifold, OnGlidePlaneLiesOnPlanes) {
  std::set<int> axes = {0, 1, 2};
  for (const Vector& x : make("on-glide-plane", 12).points) {
    if (has(Sign::negative)) {
      EXPECT_TRUE(on_fixed_space(cosets(), x, Sign::negative));
    } else {
      std::erase_if(axes, [&](int k) { return k >= x.dimension() || !(Rational(2) * x[k]).is_integer(); });
    }
  }
  EXPECT_FALSE(axes.empty());
}

TEST_P(EveryManifold, CosphericalExactlyAndNearlyNot) {
  const int d = entry().dimension;
  for (const char* metric : {"canonical", "random"}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      EXPECT_EQ(lifted_rank(make("cospherical", 16, seed, metric)), d);
      for (const long n : {d + 2, 16}) {
        const Instance near = make("near-cospherical", n, seed, metric);
        EXPECT_EQ(lifted_rank(near), d + 1);
      }
    }
  }
}

TEST_P(EveryManifold, ClusteredPointsHaveCloseNeighbours) {
  const Instance instance = make("clustered", 36);
  int close = 0;
  for (const Vector& x : instance.points)
    for (const Vector& y : instance.points)
      if (!(x == y) && near_integral(x - y, half_to(4))) {
        ++close;
        break;
      }
  EXPECT_GE(close, 30);  // six clusters: at most six points are alone
}

TEST_P(EveryManifold, SingleOrbitIsOneOrbit) {
  const Instance instance = make("single-orbit", 40);
  std::set<Vector> seen;
  for (const Vector& x : instance.points) {
    EXPECT_TRUE(equivalent(cosets(), instance.points[0], x));
    EXPECT_TRUE(seen.insert(x).second);
  }
}

TEST_P(EveryManifold, NearlyDuplicatePointsComeInPairs) {
  const Instance instance = make("nearly-duplicate", 20);
  for (std::size_t i = 0; i + 1 < instance.points.size(); i += 2)
    EXPECT_TRUE(std::any_of(cosets().begin(), cosets().end(), [&](const Isometry& g) {
      return near_integral(g * instance.points[i] - instance.points[i + 1], half_to(20));
    }));
}

TEST_P(EveryManifold, FarFromCellIsFar) {
  int far = 0;
  for (const Vector& x : make("far-from-cell", 20).points) far += abs(x[0]) > Rational(100) ? 1 : 0;
  EXPECT_GE(far, 15);
}

TEST_P(EveryManifold, LongCellReachesEveryRatio) {
  std::set<std::string> ratios;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Matrix gram = make("long-cell", 1, seed).gram;
    Rational least = gram(0, 0), most = gram(0, 0);
    for (int i = 1; i < gram.dimension(); ++i) {
      least = std::min(least, gram(i, i));
      most = std::max(most, gram(i, i));
    }
    ratios.insert((most / least).to_string());
  }
  EXPECT_EQ(ratios, (std::set<std::string>{"100", "900", "10000", "90000", "1000000"}));
}

TEST_P(EveryManifold, SkewBasisIsSkew) {
  const Instance instance = make("skew-basis", 3);
  EXPECT_TRUE(instance.generators_given);
  EXPECT_EQ(instance.name, entry().name);
  EXPECT_EQ(instance.gram.determinant(), entry().canonical_gram.determinant());
  EXPECT_GT(squared_length(instance.gram, Matrix::identity(entry().dimension).column(0)), Rational(9));
}

TEST_P(EveryManifold, MomentCurve) {
  const Instance instance = make("moment-curve", 8);
  for (const Vector& x : instance.points) {
    const Vector v = Rational(4) * (x - instance.points[0]);
    for (int k = 1; k < v.dimension(); ++k) EXPECT_EQ(v[k], v[k - 1] * v[0]);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, EveryManifold, testing::ValuesIn(manifold_names()), test_name);

}  // namespace
}  // namespace flatdt::ref
