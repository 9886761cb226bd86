/// Covers: DESIGN's table of sheets, exhaustion on random metrics of all twelve groups, limits and fallback.
#include "flatdt/ref/cover.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"
#include "lattice_samples.hpp"

namespace flatdt::ref {
namespace {

using namespace samples;

constexpr long kMaxSheets = 20000;

/// The part of a frame that covers use.
Frame make_frame(const Matrix& gram, const std::vector<Isometry>& cosets) {
  const ReducedBasis reduced = reduce_basis(gram);
  Frame frame;
  frame.dimension = gram.dimension();
  frame.gram = reduced.gram;
  for (const Isometry& coset : cosets)
    frame.cosets.push_back(
        {reduced.transform.inverse() * coset.linear * reduced.transform, Vector(frame.dimension)});
  return frame;
}

Frame torus_frame(const Matrix& gram) {
  return make_frame(gram, {Isometry::identity(gram.dimension())});
}

Matrix diagonal(const std::vector<Rational>& entries) {
  Matrix m(static_cast<int>(entries.size()));
  for (int i = 0; i < m.dimension(); ++i) m(i, i) = entries[static_cast<std::size_t>(i)];
  return m;
}

bool is_invariant(const Frame& frame, const Matrix& basis) {
  return std::all_of(frame.cosets.begin(), frame.cosets.end(), [&](const Isometry& coset) {
    return (basis.inverse() * coset.linear * basis).is_integral();
  });
}

TEST(Covers, HaveTheSheetsOfTheDesign) {
  struct Row {
    long theorem10, one_at_a_time, complete_orbits;
  };
  const std::map<std::string, Row> table = {
      {"torus", {9, 9, 9}},    {"klein-bottle", {18, 18, 18}}, {"G1", {64, 35, 27}},
      {"G2", {128, 72, 54}},   {"G3", {192, 108, 63}},         {"G4", {256, 144, 108}},
      {"G5", {384, 288, 126}}, {"G6", {256, 144, 108}},        {"B1", {128, 72, 54}},
      {"B2", {128, 72, 54}},   {"B3", {256, 144, 108}},        {"B4", {256, 144, 108}},
  };
  for (const auto& [name, row] : table) {
    const CatalogueEntry* entry = find_entry(name);
    ASSERT_NE(entry, nullptr) << name;
    const Frame frame = make_frame(entry->canonical_gram, entry->coset_representatives);
    EXPECT_EQ(theorem10_cover(frame, kMaxSheets).sheets, row.theorem10) << name;
    EXPECT_EQ(one_at_a_time_cover(frame, kMaxSheets).sheets, row.one_at_a_time) << name;
    EXPECT_EQ(complete_orbit_cover(frame).sheets, row.complete_orbits) << name;
  }
}

/// (a,p,q,b,r,c) of the columns (a,p,q), (0,b,r), (0,0,c); a plane lattice has q = r = 0, c = 1.
using Form = std::array<long, 6>;
using Coordinates = std::array<long, 3>;

Matrix to_matrix(const Form& form, int d) {
  Matrix m(d);
  m(0, 0) = form[0];
  m(1, 0) = form[1];
  m(1, 1) = form[3];
  if (d == 3) {
    m(2, 0) = form[2];
    m(2, 1) = form[4];
    m(2, 2) = form[5];
  }
  return m;
}

/// All Hermite normal forms of an index; no pruning, no order assumed.
std::vector<Form> all_normal_forms(int d, long index) {
  std::vector<Form> forms;
  for (long a = 1; a <= index; ++a) {
    for (long b = 1; a * b <= index; ++b) {
      const long c = index / (a * b);
      if (a * b * c != index || (d == 2 && c != 1)) continue;
      for (long p = 0; p < b; ++p)
        for (long q = 0; q < c; ++q)
          for (long r = 0; r < c; ++r) forms.push_back({a, p, q, b, r, c});
    }
  }
  return forms;
}

bool contains(const Form& form, Coordinates v) {
  const auto& [a, p, q, b, r, c] = form;
  if (v[0] % a != 0) return false;
  v[1] -= v[0] / a * p;
  v[2] -= v[0] / a * q;
  return v[1] % b == 0 && (v[2] - v[1] / b * r) % c == 0;
}

/// The invariant sublattice of least index without a forbidden vector, with the least columns, by exhaustion.
Matrix least_by_exhaustion(const Frame& frame, const std::vector<Coordinates>& forbidden) {
  for (long index = 1;; ++index) {
    std::vector<Form> good;
    for (const Form& form : all_normal_forms(frame.dimension, index)) {
      if (std::none_of(forbidden.begin(), forbidden.end(),
                       [&](const Coordinates& v) { return contains(form, v); }) &&
          is_invariant(frame, to_matrix(form, frame.dimension)))
        good.push_back(form);
    }
    if (!good.empty()) return to_matrix(*std::min_element(good.begin(), good.end()), frame.dimension);
  }
}

/// The invariant metric sum of R^T A R over the holonomy, A random.
Matrix random_invariant_gram(Random& random, const CatalogueEntry& entry) {
  const Matrix a = random_gram(random, entry.dimension, 3);
  Matrix sum(entry.dimension);
  for (const Isometry& coset : entry.coset_representatives)
    sum = sum + coset.linear.transpose() * a * coset.linear;
  return sum;
}

TEST(Covers, AgreeWithExhaustion) {
  Random random(1);
  for (const CatalogueEntry& entry : catalogue()) {
    int searched = 0;
    for (int round = 0; round < 4; ++round) {
      const Frame frame = make_frame(round == 0 ? entry.canonical_gram : random_invariant_gram(random, entry),
                                     entry.coset_representatives);
      const Rational bound = Rational(16) * covering_radius_squared(frame.gram);
      // Vectors of 4V are at most 4 mu long. The relevant n have coordinates -1, 0, 1 in a reduced basis.
      std::vector<Coordinates> too_short, in_four_cells;
      const std::vector<Vector> small = box(frame.dimension, 1);
      for (const Vector& g : short_vectors(frame.gram, bound)) {
        Coordinates x{};
        for (int i = 0; i < frame.dimension; ++i) x[static_cast<std::size_t>(i)] = g[i].numerator().to_long();
        too_short.push_back(x);
        if (std::all_of(small.begin(), small.end(), [&](const Vector& n) {
              return inner_product(frame.gram, g, n) <= Rational(2) * squared_length(frame.gram, n);
            }))
          in_four_cells.push_back(x);
      }
      EXPECT_EQ(complete_orbit_cover(frame).basis, least_by_exhaustion(frame, in_four_cells)) << entry.name;

      const Sublattice single = one_at_a_time_cover(frame, 1'000'000);
      EXPECT_TRUE(is_invariant(frame, single.basis));
      EXPECT_TRUE(is_safe_for_single_copies(frame.gram, single.basis));
      if (single.index > 48) continue;  // exhaustion takes the cube of the index
      ++searched;
      EXPECT_EQ(single.basis, least_by_exhaustion(frame, too_short)) << entry.name;
    }
    EXPECT_GT(searched, 0) << entry.name;
  }
}

TEST(Covers, ThreeTimesTheLatticeIsSafeForCompleteOrbits) {
  Random random(1);
  for (int round = 0; round < 30; ++round) {
    const int d = uniform(random, 2, 3);
    const Matrix skew = random_unimodular(random, d, uniform(random, 0, 8));
    const Matrix gram = skew.transpose() * random_gram(random, d, 9) * skew;
    EXPECT_TRUE(is_safe_for_complete_orbits(gram, Rational(3) * Matrix::identity(d)));
    EXPECT_FALSE(is_safe_for_complete_orbits(gram, Rational(2) * Matrix::identity(d)));
  }
}

TEST(Covers, TheCounterexampleOfTheDesignIsSafeForCompleteOrbitsOnly) {
  const Matrix gram = diagonal({1, 100}), sublattice = diagonal({12, 3});
  EXPECT_TRUE(is_safe_for_complete_orbits(gram, sublattice));
  EXPECT_FALSE(is_safe_for_single_copies(gram, sublattice));
  EXPECT_EQ(one_at_a_time_cover(torus_frame(gram), kMaxSheets).index, 39);
}

TEST(Covers, DecideQuicklyOnLongLattices) {
  EXPECT_EQ(one_at_a_time_cover(torus_frame(diagonal({1, 1'000'000})), kMaxSheets).index, 3469);
  EXPECT_THROW(one_at_a_time_cover(torus_frame(diagonal({1, 1, 1'000'000})), kMaxSheets), LimitReached);
  EXPECT_THROW(theorem10_cover(torus_frame(diagonal({1, 1'000'000})), kMaxSheets), LimitReached);

  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, 600);
  const Frame hostile = torus_frame(diagonal({1, Rational(1) / Rational(Integer(power)), Integer(power)}));
  EXPECT_EQ(complete_orbit_cover(hostile).index, 27);
  EXPECT_THROW(theorem10_cover(hostile, kMaxSheets), LimitReached);
  EXPECT_THROW(one_at_a_time_cover(hostile, kMaxSheets), LimitReached);
}

TEST(Covers, FallBackToASafeInvariantLattice) {
  int fallbacks = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    // One axis 20 times as long as the canonical metric has it: a hexagonal or square plane stays one.
    Matrix stretch = Matrix::identity(entry.dimension);
    stretch(entry.dimension - 1, entry.dimension - 1) = 20;
    Matrix gram(entry.dimension);
    for (const Isometry& coset : entry.coset_representatives)
      gram = gram + coset.linear.transpose() * stretch * entry.canonical_gram * stretch * coset.linear;
    const Frame frame = make_frame(gram, entry.coset_representatives);
    const Sublattice cover = one_at_a_time_cover(frame, 10'000'000);
    EXPECT_EQ(cover.basis.determinant(), Rational(cover.index));
    EXPECT_EQ(cover.sheets, cover.index * entry.holonomy_order);
    EXPECT_TRUE(is_invariant(frame, cover.basis)) << entry.name;
    EXPECT_TRUE(is_safe_for_single_copies(frame.gram, cover.basis)) << entry.name;
    if (entry.dimension == 3 && cover.index > kMaxSearchedIndexInSpace) ++fallbacks;
  }
  EXPECT_GE(fallbacks, 5);
  // Begun, and given up: 31 * 31 * 3 is the product lattice.
  EXPECT_EQ(one_at_a_time_cover(torus_frame(diagonal({1, 1, 225})), kMaxSheets).index, 2883);
}

}  // namespace
}  // namespace flatdt::ref
