/// What analyse() refuses and why, and that its result depends on group and metric only.
#include "flatdt/ref/group_analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "flatdt/ref/lattice.hpp"
#include "group_samples.hpp"

namespace flatdt::ref::testing {
namespace {

Rational ratio(long p, long q) {
  return {Integer(p), Integer(q)};
}

Isometry plane_element(const std::vector<Rational>& e) {
  return {make_matrix(2, {e[0], e[1], e[3], e[4]}), make_vector({e[2], e[5]})};
}

std::string reason(const Instance& instance) {
  try {
    analyse(instance);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

const Isometry kRight = plane_element({1, 0, 1, 0, 1, 0});
const Isometry kUp = plane_element({1, 0, 0, 0, 1, 1});

TEST(GroupAnalysis, NamesTheMinorThatIsNotPositive) {
  const auto refused = [](const Matrix& gram) { return reason(make_instance({kRight, kUp}, gram)); };
  EXPECT_EQ(refused(make_matrix(2, {0, 0, 0, 1})),
            "the metric is not positive definite: its leading 1x1 minor is 0, every leading minor must be "
            "positive");
  EXPECT_EQ(refused(make_matrix(2, {1, 2, 2, 3})),
            "the metric is not positive definite: its leading 2x2 minor is -1, every leading minor must be "
            "positive");
  EXPECT_EQ(reason(make_instance({Isometry::identity(3)}, make_matrix(3, {1, 0, 0, 0, 1, 1, 0, 1, 1}))),
            "the metric is not positive definite: its leading 3x3 minor is 0, every leading minor must be "
            "positive");
}

TEST(GroupAnalysis, NamesTheGeneratorThatDoesNotPreserveTheMetric) {
  const Matrix unit = Matrix::identity(2);
  EXPECT_EQ(reason(make_instance({kRight, plane_element({1, 1, 0, 0, 1, 0})}, unit)),
            "generator 1, [1 1 0 0 1 0], does not preserve the metric: entry (1,2) of R^T G R is 1, of G 0");
  EXPECT_EQ(reason(make_instance({plane_element({0, 0, 0, 0, 0, 0})}, unit)),
            "generator 0, [0 0 0 0 0 0], does not preserve the metric: entry (1,1) of R^T G R is 0, of G 1");
  EXPECT_EQ(
      reason(make_instance({kRight, kUp, plane_element({0, -1, 0, 1, -1, 0})}, unit)),
      "generator 2, [0 -1 0 1 -1 0], does not preserve the metric: entry (1,2) of R^T G R is -1, of G 0");
}

TEST(GroupAnalysis, NamesThe13thLinearPart) {
  // A rotation by arctan(4/3), of infinite order; its 12th power is the 13th linear part.
  const Isometry turn = plane_element({ratio(3, 5), ratio(-4, 5), 0, ratio(4, 5), ratio(3, 5), 0});
  Isometry power = turn;
  for (int k = 1; k < 12; ++k) power = power * turn;
  const std::string message = reason(make_instance({kRight, turn}, Matrix::identity(2)));
  EXPECT_NE(message.find("its 13th linear part is [" + power.linear.to_string() + "]"), std::string::npos)
      << message;

  std::vector<Isometry> all;  // each of them a generator: the 13th is among those given
  for (Isometry p = turn; all.size() < 20; p = p * turn) all.push_back(p);
  const std::string given = reason(make_instance(all, Matrix::identity(2)));
  EXPECT_NE(given.find("its 13th linear part is [" + power.linear.to_string() + "]"), std::string::npos)
      << given;
}

TEST(GroupAnalysis, NamesThe49thLinearPart) {
  const Isometry turn{make_matrix(3, {ratio(3, 5), ratio(-4, 5), 0, ratio(4, 5), ratio(3, 5), 0, 0, 0, 1}),
                      Vector(3)};
  Isometry power = turn;
  for (int k = 1; k < 48; ++k) power = power * turn;
  const std::string message = reason(make_instance({turn}, Matrix::identity(3)));
  EXPECT_NE(message.find("its 49th linear part is [" + power.linear.to_string().substr(0, 100)),
            std::string::npos)
      << message;
}

TEST(GroupAnalysis, NamesADirectionWithoutTranslations) {
  EXPECT_EQ(
      reason(make_instance({Isometry::identity(2)}, Matrix::identity(2))),
      "the group is not cocompact: its translations span 0 of 2 dimensions, and none moves along (1 0)");
  EXPECT_EQ(
      reason(make_instance({kUp, kUp * kUp}, make_matrix(2, {2, 1, 1, 1}))),
      "the group is not cocompact: its translations span 1 of 2 dimensions, and none moves along (-1 1)");
  const Matrix unit = Matrix::identity(3);
  for (int missing = 0; missing < 3; ++missing) {
    std::vector<Isometry> generators;
    Vector direction(3);
    direction[missing] = 1;
    for (int i = 0; i < 3; ++i)
      if (i != missing) generators.push_back(Isometry::translate(unit.column(i)));
    EXPECT_NE(reason(make_instance(generators, unit)).find("span 2 of 3 dimensions, and none moves along ("),
              std::string::npos);
    EXPECT_NE(reason(make_instance({Isometry::translate(direction)}, unit)).find("span 1 of 3"),
              std::string::npos);
  }
  // A screw alone: the square is its only translation.
  const Isometry screw{make_matrix(3, {-1, 0, 0, 0, -1, 0, 0, 0, 1}), make_vector({0, 0, ratio(1, 2)})};
  EXPECT_NE(reason(make_instance({screw}, unit)).find("span 1 of 3"), std::string::npos);
}

TEST(GroupAnalysis, ShowsAFixedPoint) {
  const Isometry half_turn = plane_element({-1, 0, ratio(1, 3), 0, -1, ratio(1, 5)});
  const Instance instance = make_instance({kRight, kUp, half_turn}, Matrix::identity(2));
  EXPECT_EQ(reason(instance),
            "the group has an element of finite order: [-1 0 1/3 0 -1 1/5] fixes (1/6 1/10), and only "
            "the identity may have a fixed point");
}

TEST(GroupAnalysis, ANameIsAClaim) {
  Instance instance =
      make_instance(find_entry("P32")->mirror_image_generators, find_entry("P31")->canonical_gram);
  for (const char* name : {"P31", "P32", "G3", "tricosm"}) {
    instance.name = name;
    EXPECT_TRUE(analyse(instance).frame.mirrored);
  }
  instance.name = "hexacosm";
  EXPECT_EQ(reason(instance),
            "the name \"hexacosm\" is wrong: the group is that of the tricosm (G3, P31, P32)");
  instance.name = "nothing";
  EXPECT_EQ(reason(instance), "no manifold is called \"nothing\"");
}

/// Field by field.
void expect_same(const GroupAnalysis& a, const GroupAnalysis& b) {
  EXPECT_EQ(a.entry, b.entry);
  EXPECT_EQ(a.lattice, b.lattice);
  EXPECT_EQ(a.cosets, b.cosets);
  EXPECT_EQ(a.volume_squared, b.volume_squared);
  EXPECT_EQ(a.frame.basis, b.frame.basis);
  EXPECT_EQ(a.frame.origin, b.frame.origin);
  EXPECT_EQ(a.frame.gram, b.frame.gram);
  EXPECT_EQ(a.frame.cosets, b.frame.cosets);
  EXPECT_EQ(a.frame.translation_denominator, b.frame.translation_denominator);
  EXPECT_EQ(a.frame.to_catalogue, b.frame.to_catalogue);
  EXPECT_EQ(a.frame.mirrored, b.frame.mirrored);
  EXPECT_EQ(a.frame.delta_squared, b.frame.delta_squared);
}

TEST(GroupAnalysis, DependsOnTheGroupOnly) {
  std::mt19937_64 random(5);
  for (const CatalogueEntry& entry : catalogue()) {
    const int d = entry.dimension;
    for (int repetition = 0; repetition < 20; ++repetition) {
      const Matrix gram = averaged(random_metric(d, random), entry.coset_representatives);
      const Vector origin = random_origin(d, random);
      const Instance instance =
          moved(make_instance(entry.generators, gram), random_unimodular(d, random), origin);
      Instance other = instance;
      auto& generators = other.generators;
      // Moves that keep the generated group: products, inverses, copies, any order.
      for (int step = 0; step < 12; ++step) {
        const std::size_t i = random() % generators.size(), j = random() % generators.size();
        if (step % 3 == 0)
          generators.push_back(generators[i] * generators[j].inverse());
        else if (i != j)
          generators[i] = step % 3 == 1 ? generators[i] * generators[j] : generators[i].inverse();
      }
      std::shuffle(generators.begin(), generators.end(), random);
      const GroupAnalysis analysis = analyse(instance);
      expect_same(analysis, analyse(other));
      expect_frame_holds(analysis, instance.gram);
      const Rational det = analysis.lattice.determinant(), order = analysis.holonomy_order;
      EXPECT_EQ(analysis.volume_squared * order * order, det * det * instance.gram.determinant());
    }
  }
}

TEST(GroupAnalysis, NamingAndListingGiveOneFrame) {
  for (const CatalogueEntry& entry : catalogue()) {
    std::vector<Isometry> listed = entry.coset_representatives;
    for (int i = 0; i < entry.dimension; ++i)
      listed.push_back(Isometry::translate(Matrix::identity(entry.dimension).column(i)));
    std::mt19937_64 random(6);
    const Matrix gram = averaged(random_metric(entry.dimension, random), entry.coset_representatives);
    Instance named = make_instance(entry.generators, gram);
    named.name = entry.name;
    named.generators_given = false;
    const GroupAnalysis analysis = analyse(named);
    expect_same(analysis, analyse(make_instance(listed, gram)));
    EXPECT_TRUE((analysis.frame.basis * analysis.frame.to_catalogue.inverse()).is_identity());
    EXPECT_TRUE(analysis.frame.origin.is_zero());
  }
}

Integer long_prime_like(int digits, long k) {
  return Integer("1" + std::string(static_cast<std::size_t>(digits), '0')) + Integer(k);
}

TEST(GroupAnalysis, HostileDenominatorsReachALimit) {
  std::vector<Isometry> generators;
  for (long k = 0; k < 1'000; ++k) {
    Vector t(3);
    for (int i = 0; i < 3; ++i) t[i] = Rational(Integer(1), long_prime_like(4000, 2 * k + 1));
    generators.push_back(Isometry::translate(t));
  }
  EXPECT_THROW(analyse(make_instance(generators, Matrix::identity(3))), LimitReached);
}

TEST(GroupAnalysis, ALongCommonDenominatorIsNoObstacle) {
  const Rational unit(Integer(1), long_prime_like(4000, 9));
  Instance instance = make_instance(find_entry("G6")->generators, Matrix::identity(3));
  const GroupAnalysis small =
      analyse(moved(instance, unit * Matrix::identity(3), unit * make_vector({1, 2, 3})));
  EXPECT_EQ(small.entry->name, "didicosm");
  EXPECT_EQ(small.frame.gram, Matrix::identity(3));
}

TEST(GroupAnalysis, ManyCoprimeDenominatorsAreAddedUp) {
  std::vector<Isometry> generators;
  Integer product = 1;
  for (long p = 2; generators.size() < 1'000; ++p) {
    if (gcd(product, Integer(p)) != Integer(1)) continue;  // so p is a prime
    product *= Integer(p);
    Vector t(2);
    t[0] = Rational(Integer(1), Integer(p));
    t[1] = t[0];
    generators.push_back(Isometry::translate(t));
  }
  generators.push_back(kRight);
  const GroupAnalysis analysis = analyse(make_instance(generators, Matrix::identity(2)));
  const Rational step(Integer(1), product);
  EXPECT_EQ(analysis.lattice, make_matrix(2, {step, 0, step, 1}));
}

TEST(GroupAnalysis, HostileRotationsReachALimit) {
  // ((1 - q^2)/(1 + q^2), 2q/(1 + q^2)) is a rational point of the circle for every rational q.
  const Rational q(Integer(1), long_prime_like(1000, 1)), one = 1;
  const Rational c = (one - q * q) / (one + q * q), s = Rational(2) * q / (one + q * q);
  const Isometry turn{make_matrix(3, {c, -s, 0, s, c, 0, 0, 0, 1}), make_vector({q, q, q})};
  EXPECT_THROW(analyse(make_instance({turn}, Matrix::identity(3))), LimitReached);
}

}  // namespace
}  // namespace flatdt::ref::testing
