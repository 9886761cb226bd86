/// delta(G)^2 against the catalogue's formulas, evaluated by enumeration, and against sampled displacements.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "flatdt/ref/group_analysis.hpp"
#include "group_samples.hpp"

namespace flatdt::ref::testing {
namespace {

const Rational kHalf(Integer(1), Integer(2)), kQuarter(Integer(1), Integer(4));

Matrix form(const Rational& a, const Rational& b, const Rational& c) {
  return make_matrix(2, {a, b, b, c});
}

/// Calls visit for the integer vectors in [-bound, bound]^d.
void for_each_vector(int dimension, long bound, const std::function<void(const Vector&)>& visit) {
  Vector v(dimension);
  const std::function<void(int)> fill = [&](int i) {
    if (i == dimension) return visit(v);
    for (long x = -bound; x <= bound; ++x) {
      v[i] = x;
      fill(i + 1);
    }
  };
  fill(0);
}

/// cm(q, k): the least value of q on nonzero integer vectors congruent to k modulo 2. A vector v with
/// q(v) <= q(k) has v_i^2 <= q(k) (q^-1)_ii (Cauchy-Schwarz), so the search is exhaustive.
Rational cm(const Matrix& q, const Vector& k) {
  Rational least = squared_length(q, k), widest;
  const Matrix inverse = q.inverse();
  for (int i = 0; i < q.dimension(); ++i) widest = std::max(widest, least * inverse(i, i));
  long bound = 0;
  while (Rational(bound) * Rational(bound) < widest) ++bound;
  for_each_vector(q.dimension(), bound, [&](const Vector& v) {
    if ((kHalf * (v - k)).is_integral()) least = std::min(least, squared_length(q, v));
  });
  return least;
}

Rational cm(const Matrix& q, int k0, int k1) {
  return cm(q, make_vector({k0, k1}));
}

/// The least of cm(q, k) over all classes but 0.
Rational least_odd(const Matrix& q) {
  Rational least = q(0, 0);
  for_each_vector(q.dimension(), 1, [&](const Vector& v) {
    if (!v.is_zero()) least = std::min(least, cm(q, v));
  });
  return least;
}

using Formula = std::function<Rational(const Matrix&)>;

/// The field delta_squared.formula of the catalogue, transcribed.
const std::map<std::string, Formula>& formulas() {
  static const std::map<std::string, Formula> all = {
      {"torus", least_odd},
      {"torocosm", least_odd},
      {"klein-bottle", [](const Matrix& g) { return std::min(g(0, 0), kQuarter * g(1, 1)); }},
      {"dicosm",
       [](const Matrix& g) {
         return std::min(kQuarter * g(2, 2), least_odd(form(g(0, 0), g(0, 1), g(1, 1))));
       }},
      {"tricosm",
       [](const Matrix& g) { return std::min(g(0, 0), Rational(Integer(1), Integer(9)) * g(2, 2)); }},
      {"tetracosm", [](const Matrix& g) { return std::min(g(0, 0), kQuarter * kQuarter * g(2, 2)); }},
      {"hexacosm",
       [](const Matrix& g) { return std::min(g(0, 0), Rational(Integer(1), Integer(36)) * g(2, 2)); }},
      {"didicosm",
       [](const Matrix& g) {
         return kQuarter * std::min({g(0, 0), g(1, 1), g(2, 2)});
       }},
      {"first-amphicosm",
       [](const Matrix& g) {
         return std::min(g(1, 1), least_odd(form(g(0, 0), kHalf * g(0, 2), kQuarter * g(2, 2))));
       }},
      {"second-amphicosm",
       [](const Matrix& g) {
         const Rational b = Rational(2) * (g(0, 0) - g(0, 1));
         const Matrix q = form(kHalf * (g(0, 0) + g(0, 1)), kHalf * g(0, 2), kQuarter * g(2, 2));
         return std::min(
             {b, cm(q, 0, 1), cm(q, 1, 1), cm(q, 1, 0) + kQuarter * b, Rational(4) * cm(q, 1, 0)});
       }},
      {"first-amphidicosm",
       [](const Matrix& g) {
         return std::min({kQuarter * g(0, 0), g(1, 1), kQuarter * g(2, 2)});
       }},
      {"second-amphidicosm",
       [](const Matrix& g) {
         return std::min({kQuarter * g(0, 0), g(1, 1), kQuarter * g(2, 2)});
       }},
  };
  return all;
}

TEST(GroupDelta, EqualsTheFormulasOfTheCatalogue) {
  std::mt19937_64 random(7);
  for (const CatalogueEntry& entry : catalogue()) {
    const Formula& formula = formulas().at(entry.name);
    EXPECT_EQ(formula(entry.canonical_gram), entry.canonical_delta_squared) << entry.name;
    for (int repetition = 0; repetition < 60; ++repetition) {
      Matrix metric = random_metric(entry.dimension, random);
      if (entry.name == "torocosm")  // the exhaustive search has three dimensions here
        metric = metric + Rational(30) * entry.canonical_gram;
      const Matrix gram = averaged(metric, entry.coset_representatives);
      const GroupAnalysis analysis = analyse(make_instance(entry.generators, gram));
      EXPECT_EQ(analysis.frame.delta_squared, formula(gram)) << entry.name << " " << gram.to_string();
    }
  }
}

TEST(GroupDelta, NoElementMovesAPointByLessAndSomeElementByThat) {
  std::mt19937_64 random(8);
  for (const CatalogueEntry& entry : catalogue()) {
    const int d = entry.dimension;
    for (int repetition = 0; repetition < 2; ++repetition) {
      // Near a multiple of the identity the shortest displacements have small coordinates.
      const Matrix metric = Rational(20) * entry.canonical_gram + random_metric(d, random);
      const Matrix gram = averaged(metric, entry.coset_representatives);
      const Rational delta_squared = analyse(make_instance(entry.generators, gram)).frame.delta_squared;
      bool attained = false;
      // Points with coordinates in quarters contain, for each element of the catalogue's groups, one that the
      // element moves by the least distance: its axis or mirror is at a quarter.
      for_each_vector(d, 2, [&](const Vector& numerators) {
        const Vector p = kQuarter * numerators;
        for_each_vector(d, 1, [&](const Vector& l) {
          for (const Isometry& coset : entry.coset_representatives) {
            const Isometry g{coset.linear, coset.translation + l};
            if (g.is_identity()) continue;
            const Rational moved_by = squared_length(gram, p - g * p);
            EXPECT_GE(moved_by, delta_squared) << entry.name;
            attained = attained || moved_by == delta_squared;
          }
        });
      });
      EXPECT_TRUE(attained) << entry.name;
    }
  }
}

}  // namespace
}  // namespace flatdt::ref::testing
