/// The stages of the predicates agree where the filter is at its limit: points 2^-k off a sphere or a plane,
/// exactly on it, with large common offsets and in metrics of extreme scale. The third evaluation is the
/// definition, in rationals. And whole outputs are the same bytes with and without the filter.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "engine.hpp"
#include "for_all.hpp"
#include "geometry.hpp"
#include "judge.hpp"
#include "quotient.hpp"
#include "random.hpp"
#include "require.hpp"

namespace flatdt::property_tests {
namespace {

using ref::Integer;
using ref::Lift;
using ref::OrbitPoint;
using ref::PredicateStages;
using ref::Sign;
using testing::Random;

Rational power_of_half(long k) {
  Integer power(1);
  for (long i = 0; i < k; ++i) power += power;
  return {Integer(1), power};
}

Vector random_vector(int d, long range, long denominator, Random& random) {
  Vector v(d);
  for (int i = 0; i < d; ++i) v[i] = random.fraction(-range, range, denominator);
  return v;
}

/// d+2 points: a simplex and one more, which lies off its sphere (or off the plane of its first facet) by
/// about 2^-k of a unit, k as in the filter's error bound, or exactly on it.
std::vector<Vector> near_degenerate(const Matrix& gram, Random& random) {
  const int d = gram.dimension();
  const long denominator = random.one_in(2) ? 4 : 1000003;
  for (;;) {  // three or four random points are on a line or a plane with probability below 1/2
    std::vector<Vector> p;
    for (int k = 0; k <= d; ++k) p.push_back(random_vector(d, 2 * denominator, denominator, random));
    const std::optional<Sphere> sphere = circumsphere(gram, p);
    if (!sphere) continue;
    Vector w(d);
    if (random.one_in(3)) {
      // A combination of the first d points: on their plane.
      Rational rest(1);
      for (int k = 1; k < d; ++k) {
        const Rational share = random.fraction(-3, 5, 4);
        w = w + share * p[static_cast<std::size_t>(k)];
        rest -= share;
      }
      w = w + rest * p[0];
    } else {
      // The second point of the sphere on the line from p_0 with direction v.
      const Vector v = random_vector(d, 5, 1, random);
      if (v.is_zero()) continue;
      const Rational s =
          Rational(-2) * inner_product(gram, p[0] - sphere->centre, v) / squared_length(gram, v);
      w = p[0] + s * v;
    }
    if (!random.one_in(4)) {
      Vector off = random_vector(d, 3, 1, random);
      w = w + power_of_half(random.between(20, 90)) * off;
    }
    p.push_back(w);
    return p;
  }
}

struct StageVisits {
  int zero_orientations = 0, zero_inspheres = 0, silent_filters = 0, speaking_filters = 0;
};

/// The d+2 points as lifts of orbit points of an engine, all moved by one translation.
template <int D>
std::array<Lift, D + 2> lifts_of(const Engine<D>& engine, const std::array<std::int16_t, 3>& offset) {
  const Isometry to_frame = Isometry{engine.analysis.frame.basis, engine.analysis.frame.origin}.inverse();
  std::array<Lift, D + 2> lifts;
  for (const ref::Site& site : engine.sites) {
    const ref::SiteId id{static_cast<std::uint32_t>(&site - engine.sites.data())};
    const Vector at = engine.position({id, {}});
    for (std::size_t i = 0; i < D + 2; ++i) {
      // p = g * site; g is found from the positions: from_site is given for one of the points only.
      const Vector x = to_frame * engine.instance.points[i];
      for (const Isometry& coset : engine.analysis.frame.cosets) {
        const Vector shift = x - coset * at;
        if (!shift.is_integral()) continue;
        ref::Element g = engine.table.element(Isometry::translate(shift) * coset);
        g = engine.table.multiply(ref::Element{offset, 0}, g);
        lifts[i] = engine.lift({id, g});
      }
    }
  }
  return lifts;
}

template <int D>
void require_stages_agree(const ref::Instance& instance, const std::array<std::int16_t, 3>& offset,
                          StageVisits& visits) {
  Engine<D> filtered(instance, PredicateStages::filtered);
  Engine<D> exact(instance, PredicateStages::exact_only);
  const Matrix& gram = filtered.analysis.frame.gram;
  const std::array<Lift, D + 2> lifts = lifts_of<D>(filtered, offset);
  std::vector<Vector> x;
  x.reserve(lifts.size());
  for (const Lift& lift : lifts) x.push_back(filtered.position(lift.point));
  for (std::size_t out = 0; out < D + 2; ++out) {
    std::array<Lift, D + 1> cell;
    std::vector<Vector> corners;
    for (std::size_t k = 0, i = 0; k < D + 2; ++k)
      if (k != out) {
        cell[i++] = lifts[k];
        corners.push_back(x[k]);
      }
    const Sign by_definition = orientation(corners);
    require(exact.predicates.orientation(cell) == by_definition, "the exact orientation is wrong");
    require(filtered.predicates.orientation(cell) == by_definition, "the filtered orientation is wrong");
    if (by_definition == Sign::zero) {
      ++visits.zero_orientations;
      continue;
    }
    if (by_definition == Sign::negative) std::swap(cell[0], cell[1]);
    const Lift& w = lifts[out];
    if (std::find_if(cell.begin(), cell.end(), [&](const Lift& p) { return p.point == w.point; }) !=
        cell.end())
      continue;  // two of the points are one: no cell has w as a vertex and in conflict
    const Sphere sphere = *circumsphere(gram, corners);
    const Sign inside = (sphere.squared_radius - squared_length(gram, x[out] - sphere.centre)).sign();
    require(exact.predicates.insphere(cell, w) == inside, "the exact insphere is wrong");
    require(filtered.predicates.insphere(cell, w) == inside, "the filtered insphere is wrong");
    const bool conflict = exact.predicates.conflict_sos(cell, w);
    require(filtered.predicates.conflict_sos(cell, w) == conflict,
            "the conflict after perturbation depends on the filter");
    require(inside == Sign::zero || conflict == (inside == Sign::positive),
            "the perturbation contradicts the insphere");
    if (inside == Sign::zero) ++visits.zero_inspheres;
    std::array<std::array<double, 3>, D + 1> approximate;
    for (std::size_t k = 0; k <= D; ++k) approximate[k] = cell[k].x;
    ++(filtered.predicates.filter().insphere(approximate, w.x) ? visits.speaking_filters
                                                               : visits.silent_filters);
  }
}

/// The specimen gives manifold, metric and coordinates; its choice gives the points.
void stages_agree(const Specimen& s, StageVisits& visits) {
  Random random(s.choice);
  Specimen t = s;
  t.points = near_degenerate(s.gram, random);
  std::array<std::int16_t, 3> offset{};
  if (random.one_in(2))
    for (int i = 0; i < s.dimension(); ++i) {
      const long reach = random.one_in(2) ? 5 : 8000;
      offset[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(random.between(-reach, reach));
    }
  if (s.dimension() == 2)
    require_stages_agree<2>(instance_of(t), offset, visits);
  else
    require_stages_agree<3>(instance_of(t), offset, visits);
}

void same_bytes(const Specimen& s) {
  const ref::Instance instance = instance_of(s);
  ref::TriangulationOptions exact;
  exact.stages = PredicateStages::exact_only;
  const auto a = triangulate(instance);
  const auto b = triangulate(instance, exact);
  require(
      write_triangulation(a.triangulation, describe(a)) == write_triangulation(b.triangulation, describe(b)),
      "the bytes depend on the filter");
}

void run_stages(int cases, Domain domain) {
  domain.rules = {testing::kSmallGridRule};  // the points are replaced
  domain.max_points_in_plane = domain.max_points_in_space = 1;
  StageVisits visits;
  if (for_all({cases, domain}, [&](const Specimen& s) { stages_agree(s, visits); }) == 0) return;
  // The boundary was really visited, from both sides.
  EXPECT_GT(visits.zero_orientations, cases / 50);
  EXPECT_GT(visits.zero_inspheres, cases / 20);
  EXPECT_GT(visits.silent_filters, cases / 2);
  EXPECT_GT(visits.speaking_filters, cases / 2);
}

TEST(Exactness, StagesAgreeInThePlane) {
  run_stages(600, plane());
}
TEST(Exactness, StagesAgreeInSpace) {
  run_stages(250, space());
}

TEST(Exactness, SameBytesInThePlane) {
  Domain domain = plane();
  domain.rules = {"near-cospherical", "nearly-duplicate", "cospherical", "clustered", "moment-curve", "grid"};
  for_all({40, domain}, same_bytes);
}
TEST(Exactness, SameBytesInSpace) {
  Domain domain = space();
  domain.rules = {"near-cospherical", "nearly-duplicate", "cospherical", "clustered", "moment-curve", "grid"};
  for_all({4, domain}, same_bytes);
}

}  // namespace
}  // namespace flatdt::property_tests
