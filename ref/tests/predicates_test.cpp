/// The stages of the predicates agree, on random points and on inputs built to sit on the filter's boundary;
/// the symbolic perturbation has the properties that make it a perturbation.
#include "flatdt/ref/predicates.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "fixed_sphere.hpp"
#include "flatdt/ref/families.hpp"
#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/quotient_complex.hpp"
#include "split_mix.hpp"
#include "star_filter.hpp"

namespace flatdt::ref {
namespace {

int below(SplitMix64& random, int n) {
  return static_cast<int>(random.next() % static_cast<std::uint64_t>(n));
}

/// A manifold with points, ready for predicates.
template <int D>
struct World {
  explicit World(const Instance& given)
      : instance(given),
        analysis(analyse(instance)),
        table(analysis.frame),
        sites(make_sites(analysis.frame, instance.points)),
        order(analysis.frame, table),
        filtered(analysis.frame, table, sites, order, PredicateStages::filtered),
        fixed(analysis.frame, table, sites, order, PredicateStages::fixed_only),
        exact(analysis.frame, table, sites, order, PredicateStages::exact_only) {}

  OrbitPoint random_point(SplitMix64& random, int reach) const {
    Element g;
    g.coset = static_cast<std::uint16_t>(below(random, table.cosets()));
    for (std::size_t i = 0; i < D; ++i)
      g.t[i] = static_cast<std::int16_t>(below(random, 2 * reach + 1) - reach);
    return {SiteId{static_cast<std::uint32_t>(below(random, static_cast<int>(sites.size())))}, g};
  }
  Lift lift(const OrbitPoint& p) const {
    return {table.apply(p.g, sites[index_of(p.site)].approximate()), p};
  }

  /// Exact coordinates in the frame.
  Vector position(const OrbitPoint& p) const {
    Vector x(D);
    const Site& site = sites[index_of(p.site)];
    for (int i = 0; i < D; ++i) x[i] = Rational(site.numerator(i), site.denominator());
    return table.isometry(p.g) * x;
  }

  Instance instance;
  GroupAnalysis analysis;
  GroupTable table;
  std::vector<Site> sites;
  TieOrder order;
  Predicates<D> filtered, fixed, exact;
};

Instance make(const char* manifold, const char* family, long n, std::uint64_t seed) {
  return generate(*find_entry(manifold), manifold, family, n, seed, "canonical");
}

/// Sign of the definition: |w - c|^2 against R^2 with the circumcentre c computed in rationals.
template <int D>
Sign insphere_by_definition(const World<D>& world, const std::array<Lift, D + 1>& cell, const Lift& w) {
  const Matrix& gram = world.analysis.frame.gram;
  const Vector origin = world.position(cell[0].point);
  Matrix rows(D);
  Vector half_lengths(D);
  for (int k = 0; k < D; ++k) {
    const Vector a = world.position(cell[static_cast<std::size_t>(k) + 1].point) - origin;
    const Vector ga = gram * a;
    for (int j = 0; j < D; ++j) rows(k, j) = ga[j];
    half_lengths[k] = Rational(Integer(1), Integer(2)) * squared_length(gram, a);
  }
  const Vector centre = rows.inverse() * half_lengths;
  const Vector x = world.position(w.point) - origin;
  return (squared_length(gram, centre) - squared_length(gram, x - centre)).sign();
}

/// By the filter for stars, with the cell's first vertex for the centre; the cell positively oriented.
template <int D>
std::optional<Sign> insphere_about_first(const World<D>& world, const std::array<Lift, D + 1>& cell,
                                         const Lift& w) {
  StarFilter<D> filter(world.filtered.filter(), cell[0].x, true);
  std::array<typename StarFilter<D>::Offset, D> others;
  for (std::size_t k = 0; k < D; ++k) others[k] = filter.see(cell[k + 1].x);
  const auto seen = filter.see(w.x);
  std::array<typename StarFilter<D>::Offset, D - 1> base;
  std::copy(others.begin(), others.end() - 1, base.begin());
  if (const auto sign = filter.orientation(filter.plane(base), others[D - 1])) {
    EXPECT_EQ(*sign, Sign::positive);
  }
  const auto sign = filter.insphere(filter.sphere(others, false), seen);
  std::swap(others[0], others[1]);
  EXPECT_EQ(filter.insphere(filter.sphere(others, true), seen), sign);
  return sign;
}

template <int D>
void stages_agree(const Instance& instance, std::uint64_t seed, int& zero_orientations, int& zero_inspheres) {
  World<D> world(instance);
  SplitMix64 random(seed);
  for (int round = 0; round < 400; ++round) {
    std::array<Lift, D + 1> cell;
    for (Lift& p : cell) p = world.lift(world.random_point(random, round % 3));
    const Sign orientation = world.exact.orientation(cell);
    ASSERT_EQ(world.filtered.orientation(cell), orientation);
    ASSERT_EQ(world.fixed.orientation(cell), orientation);
    if (orientation == Sign::zero) {
      ++zero_orientations;
      continue;
    }
    if (orientation == Sign::negative) std::swap(cell[0], cell[1]);
    const Lift w = world.lift(world.random_point(random, round % 3));
    bool is_vertex = false;
    for (const Lift& p : cell) is_vertex = is_vertex || p.point == w.point;
    if (is_vertex) continue;
    const Sign insphere = world.exact.insphere(cell, w);
    if (const auto sign = insphere_about_first<D>(world, cell, w)) {
      ASSERT_EQ(*sign, insphere);
    }
    ASSERT_EQ(world.filtered.insphere(cell, w), insphere);
    ASSERT_EQ(world.fixed.insphere(cell, w), insphere);
    ASSERT_EQ(insphere_by_definition<D>(world, cell, w), insphere);
    if (insphere == Sign::zero) ++zero_inspheres;
    // The perturbed predicate never contradicts the exact one and does not depend on the listing of the cell.
    const bool conflict = world.filtered.conflict_sos(cell, w);
    if (insphere != Sign::zero) {
      ASSERT_EQ(conflict, insphere == Sign::positive);
    }
    std::array<Lift, D + 1> even = cell;
    std::swap(even[0], even[1]);
    std::swap(even[1], even[2]);
    ASSERT_EQ(world.exact.conflict_sos(even, w), conflict);
  }
}

TEST(Predicates, StagesAgreeOnEveryManifoldAndFamily) {
  int zero_orientations = 0;
  int zero_inspheres = 0;
  std::uint64_t seed = 1;
  for (const CatalogueEntry& entry : catalogue()) {
    for (const char* family :
         {"uniform", "grid", "cospherical", "near-cospherical", "clustered", "far-from-cell"}) {
      const Instance instance = make(entry.name.c_str(), family, 8, seed++);
      if (entry.dimension == 2)
        stages_agree<2>(instance, seed, zero_orientations, zero_inspheres);
      else
        stages_agree<3>(instance, seed, zero_orientations, zero_inspheres);
    }
  }
  // The degenerate cases were really visited.
  EXPECT_GT(zero_orientations, 100);
  EXPECT_GT(zero_inspheres, 100);
}

/// Metrics and denominators just inside and just outside the limits of the fixed width, 2^62 each, and of its
/// narrow and middle forms, and coordinates that differ by almost a period: the products come as near to
/// their bounds as they can.
TEST(Predicates, FixedWidthAtItsLimits) {
  std::vector<std::pair<unsigned, int>> sizes;  // bits of the denominator and of the metric
  for (const int bits : {20, 40, 60, 61, 62, 63}) sizes.emplace_back(61, bits);
  for (const unsigned denominator_bits : {20U, 50U, 56U}) {
    const int last = denominator_bits == 20 ? 118 - 5 * 20 : 123 - 2 * static_cast<int>(denominator_bits);
    for (int bits = last - 12; bits <= last + 1; ++bits)
      if (bits > 1) sizes.emplace_back(denominator_bits, bits);
  }
  for (const auto& [denominator_bits, bits] : sizes) {
    SCOPED_TRACE(denominator_bits);
    const mpz_class one = 1;
    const std::string large = mpz_class((one << static_cast<unsigned long>(bits)) - 1).get_str();
    const std::string denominator = mpz_class((one << denominator_bits) - 1).get_str();
    const std::string almost = mpz_class((one << denominator_bits) - 3).get_str() + "/" + denominator;
    const std::string few = "2/" + denominator;
    std::ostringstream text;
    text << "flatdt-instance 1\ndimension 3\nmanifold 3-torus\nmetric " << large << " 1 -1 " << large << " 1 "
         << large << "\npoints 4\n0 0 0\n"
         << almost << ' ' << few << " 0\n"
         << few << ' ' << almost << ' ' << few << '\n'
         << almost << ' ' << almost << ' ' << almost << '\n';
    const Instance instance = parse_instance(text.str(), "limits");
    const World<3> world(instance);
    const FixedPredicates<3> fixed(world.analysis.frame, world.table, world.sites);
    ExactPredicates<3> exact(world.analysis.frame, world.table, world.sites);
    SplitMix64 random(static_cast<std::uint64_t>(bits));
    int spoken = 0;
    int powers = 0;
    for (int round = 0; round < 300; ++round) {
      std::array<OrbitPoint, 4> cell;
      for (OrbitPoint& p : cell) p = world.random_point(random, round % 3);
      const OrbitPoint w = world.random_point(random, round % 3);
      if (const auto sign = fixed.orientation(cell)) {
        ASSERT_EQ(*sign, exact.orientation(cell));
      }
      if (const auto sign = fixed.insphere(cell, w)) {
        ++spoken;
        ASSERT_EQ(*sign, exact.insphere(cell, w));
        const auto sphere = FixedSphere<3>::make(fixed, cell);
        if (const auto power = sphere ? sphere->power(w) : std::nullopt) {
          ++powers;
          ASSERT_EQ(power->sign(), *sign);
        }
      }
    }
    EXPECT_EQ(spoken > 0, bits <= 62) << bits;
    EXPECT_EQ(powers > 0, bits <= 62) << bits;
  }
}

/// Each point keeps a denominator of its own when the common one would be too long: d + 2 points are
/// rescaled.
TEST(Predicates, StagesAgreeOnUnrelatedLongDenominators) {
  int zero_orientations = 0;
  int zero_inspheres = 0;
  SplitMix64 random(9);
  for (const char* manifold : {"klein-bottle", "dicosm"}) {
    Instance instance = make(manifold, "uniform", 6, 1);
    for (std::size_t i = 0; i < instance.points.size(); ++i) {
      mpz_class denominator;  // powers of six primes, about 140 bits each
      constexpr std::array<std::pair<unsigned long, unsigned long>, 6> kPowers{
          {{3, 90}, {5, 60}, {7, 50}, {11, 40}, {13, 38}, {17, 34}}};
      mpz_ui_pow_ui(denominator.get_mpz_t(), kPowers[i].first, kPowers[i].second);
      for (int k = 0; k < instance.dimension; ++k)
        instance.points[i][k] =
            Rational(Integer(mpz_class(denominator / (2 + below(random, 97)))), Integer(denominator));
    }
    if (instance.dimension == 2)
      stages_agree<2>(instance, 1, zero_orientations, zero_inspheres);
    else
      stages_agree<3>(instance, 2, zero_orientations, zero_inspheres);
  }
}

/// Points on a line across the end of a long cover, where base positions are of the size of the cover and
/// lifts are not: the filter must not take the rounding of the former for the side of a point.
TEST(Predicates, LiftsAcrossTheEndOfALongCover) {
  constexpr int kLength = 20011;
  std::string text = "flatdt-instance 1\ndimension 2\nmanifold torus\npoints 16\n";
  for (int k = 0; k < 16; ++k)  // x = 1/5 + 2 y / 3
    text += std::to_string(96 + 10 * k * 2) + "/480 " + std::to_string(k) + "/16\n";
  const World<2> world(parse_instance(text, "line"));
  Matrix basis(2);
  basis(0, 0) = kLength;
  basis(1, 1) = 1;
  QuotientComplex<2> complex(world.table, world.sites,
                             Subgroup::sublattice(world.table, {basis, kLength, kLength}));
  for (std::uint32_t i = 0; i < world.sites.size(); ++i) complex.add_site(SiteId{i});
  Predicates<2> filtered(world.analysis.frame, world.table, world.sites, world.order,
                         PredicateStages::filtered);
  SplitMix64 random(1);
  int zero = 0;
  for (int round = 0; round < 1000; ++round) {
    std::array<Lift, 3> cell;
    for (Lift& p : cell) {
      const Element g{{static_cast<std::int16_t>(-below(random, 2)), 0, 0}, 0};
      const Subgroup::Split split = complex.subgroup().split(g);
      p = complex.lift(complex.vertex_of(SiteId{static_cast<std::uint32_t>(below(random, 16))}, split.rep),
                       split.s);
      ASSERT_EQ(p.point.g, g);
    }
    ExactPredicates<2> exact(world.analysis.frame, world.table, world.sites);
    const Sign sign = exact.orientation({cell[0].point, cell[1].point, cell[2].point});
    zero += sign == Sign::zero ? 1 : 0;
    ASSERT_EQ(filtered.orientation(cell), sign) << round;
  }
  EXPECT_GT(zero, 100);
}

TEST(Predicates, FilterIsSilentOnExactTies) {
  const World<3> world(make("torocosm", "grid", 8, 5));
  const Filter<3>& filter = world.filtered.filter();
  const auto corner = [](double x, double y, double z) { return std::array<double, 3>{x, y, z}; };
  EXPECT_FALSE(
      filter.insphere({corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1)}, corner(1, 1, 1)));
  EXPECT_FALSE(filter.orientation({corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0), corner(1, 1, 0)}));
  EXPECT_EQ(filter.orientation({corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1)}),
            Sign::positive);
  EXPECT_EQ(filter.insphere({corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1)},
                            corner(0.5, 0.5, 0.5)),
            Sign::positive);
  EXPECT_EQ(
      filter.insphere({corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1)}, corner(2, 1, 1)),
      Sign::negative);
}

/// A square with corners 00 < 10 < 01 < 11 in the tie order (key y, x): the diagonal is 10-01 (INSERTION 2).
TEST(Perturbation, UnitSquareOfTheTorus) {
  Instance instance = make("torus", "uniform", 1, 1);
  instance.points[0] = Vector(2);
  World<2> world(instance);
  const auto corner = [&](int x, int y) {
    return world.lift(
        OrbitPoint{SiteId{0}, Element{{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), 0}, 0}});
  };
  EXPECT_TRUE(world.exact.conflict_sos({corner(0, 0), corner(1, 0), corner(1, 1)}, corner(0, 1)));
  EXPECT_FALSE(world.exact.conflict_sos({corner(0, 0), corner(1, 0), corner(0, 1)}, corner(1, 1)));
}

/// Cube with corners A < B < C < D < E < F < G < H in the tie order (key z, x, y): the cells are ABCE, BCDE,
/// BDEF, CDEG, DEFG, DFGH (INSERTION 2). Each is in conflict with no other corner.
TEST(Perturbation, UnitCubeOfTheTorus) {
  Instance instance = make("torocosm", "uniform", 1, 1);
  instance.points[0] = Vector(3);
  World<3> world(instance);
  const auto corner = [&](char name) {
    static const std::array<std::array<std::int16_t, 3>, 8> kCorners{
        {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}}};
    return world.lift(OrbitPoint{SiteId{0}, Element{kCorners[static_cast<std::size_t>(name - 'A')], 0}});
  };
  int cells = 0;
  const std::string all = "ABCDEFGH";
  for (int mask = 0; mask < 256; ++mask) {
    std::string name;
    for (std::size_t i = 0; i < 8; ++i)
      if (((mask >> i) & 1) != 0) name += all[i];
    if (name.size() != 4) continue;
    std::array<Lift, 4> cell{corner(name[0]), corner(name[1]), corner(name[2]), corner(name[3])};
    const Sign sign = world.exact.orientation(cell);
    if (sign == Sign::zero) continue;
    if (sign == Sign::negative) std::swap(cell[0], cell[1]);
    bool empty = true;
    for (const char w : all)
      if (name.find(w) == std::string::npos) empty = empty && !world.exact.conflict_sos(cell, corner(w));
    const bool expected = name == "ABCE" || name == "BCDE" || name == "BDEF" || name == "CDEG" ||
                          name == "DEFG" || name == "DFGH";
    EXPECT_EQ(empty, expected) << name;
    cells += empty ? 1 : 0;
  }
  EXPECT_EQ(cells, 6);
}

/// The order is total, and left-invariant under its invariance group: a < b implies g a < g b.
TEST(TieOrder, IsLeftInvariant) {
  SplitMix64 random(7);
  for (const CatalogueEntry& entry : catalogue()) {
    const Instance instance = make(entry.name.c_str(), "uniform", 3, 11);
    const Frame frame = analyse(instance).frame;
    const GroupTable table(frame);
    const TieOrder order(frame, table);
    const auto element = [&] {
      Element g;
      g.coset = static_cast<std::uint16_t>(below(random, table.cosets()));
      for (int i = 0; i < entry.dimension; ++i)
        g.t[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(below(random, 5) - 2);
      return g;
    };
    EXPECT_EQ(order.invariance_group().is_whole(), entry.left_orderable) << entry.name;
    for (int round = 0; round < 300; ++round) {
      const Element a = element(), b = element(), g = element();
      if (a == b) {
        EXPECT_FALSE(order.element_less(a, b));
        continue;
      }
      EXPECT_NE(order.element_less(a, b), order.element_less(b, a));
      if (order.invariance_group().split(g).rep != 0) continue;
      EXPECT_EQ(order.element_less(table.multiply(g, a), table.multiply(g, b)), order.element_less(a, b));
    }
  }
}

TEST(Perturbation, IsInvariantUnderTheGroupOnTies) {
  SplitMix64 random(3);
  int ties = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.dimension != 3) continue;
    World<3> world(make(entry.name.c_str(), "grid", 4, 2));
    for (int round = 0; round < 4000; ++round) {
      std::array<Lift, 4> cell;
      for (Lift& p : cell) p = world.lift(world.random_point(random, 1));
      const Sign sign = world.exact.orientation(cell);
      if (sign == Sign::zero) continue;
      if (sign == Sign::negative) std::swap(cell[0], cell[1]);
      const Lift w = world.lift(world.random_point(random, 1));
      bool is_vertex = false;
      for (const Lift& p : cell) is_vertex = is_vertex || p.point == w.point;
      if (is_vertex || world.exact.insphere(cell, w) != Sign::zero) continue;
      ++ties;
      const Element g = world.random_point(random, 2).g;
      if (world.order.invariance_group().split(g).rep != 0) continue;
      std::array<Lift, 4> image;
      for (std::size_t k = 0; k < 4; ++k)
        image[k] = world.lift(OrbitPoint{cell[k].point.site, world.table.multiply(g, cell[k].point.g)});
      if (world.table.reverses_orientation(g)) std::swap(image[0], image[1]);
      const Lift moved = world.lift(OrbitPoint{w.point.site, world.table.multiply(g, w.point.g)});
      ASSERT_EQ(world.exact.conflict_sos(image, moved), world.exact.conflict_sos(cell, w)) << entry.name;
    }
  }
  EXPECT_GT(ties, 200);
}

/// GroupTable against exact isometries.
TEST(GroupTable, MultipliesLikeIsometries) {
  SplitMix64 random(5);
  for (const CatalogueEntry& entry : catalogue()) {
    const Frame frame = analyse(make(entry.name.c_str(), "skew-basis", 2, 4)).frame;
    const GroupTable table(frame);
    for (int round = 0; round < 100; ++round) {
      Element g, h;
      g.coset = static_cast<std::uint16_t>(below(random, table.cosets()));
      h.coset = static_cast<std::uint16_t>(below(random, table.cosets()));
      for (int i = 0; i < entry.dimension; ++i) {
        g.t[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(below(random, 21) - 10);
        h.t[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(below(random, 21) - 10);
      }
      EXPECT_EQ(table.isometry(table.multiply(g, h)), table.isometry(g) * table.isometry(h));
      EXPECT_TRUE(table.multiply(g, table.inverse(g)).is_identity());
      EXPECT_TRUE(table.multiply(table.inverse(g), g).is_identity());
      EXPECT_EQ(table.element(table.isometry(g)), g);
    }
    Element far;
    far.t[0] = 32000;
    EXPECT_THROW(static_cast<void>(table.multiply(far, far)), LimitReached);
  }
}

}  // namespace
}  // namespace flatdt::ref
