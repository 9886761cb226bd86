#include "orbits.hpp"

#include <algorithm>
#include <compare>
#include <numeric>
#include <utility>

#include "linear.hpp"

namespace flatdt::checker {
namespace {

struct Canonical {
  LatticePoint point;
  Element to_point;  // point of the instance = to_point * canonical point
};

int compare(const Vec<Integer>& a, const Vec<Integer>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (const int c = cmp(a[i], b[i]); c != 0) return c;
  }
  return 0;
}

// All images of one point are compared over one denominator; only the minimum is brought to lowest terms.
Canonical canonical_point(const Group& group, const Integer& group_denominator, const Vec<Rational>& point) {
  const int d = group.dimension;
  const Vec<Rational> x = multiply(d, group.basis_inverse, point);
  LatticePoint best;
  best.denominator = group_denominator;
  for (const Rational& coordinate : x) best.denominator = lcm(best.denominator, coordinate.get_den());
  Vec<Integer> scaled;
  for (std::size_t i = 0; i < 3; ++i) scaled[i] = x[i].get_num() * (best.denominator / x[i].get_den());
  Element to_canonical;
  for (std::size_t r = 0; r < group.order(); ++r) {
    Vec<Integer> image = multiply(d, group.linear[r], scaled);
    Vec<Integer> shift;
    for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
      const Rational& t = group.translation[r][i];
      image[i] += t.get_num() * (best.denominator / t.get_den());
      mpz_fdiv_qr(shift[i].get_mpz_t(), image[i].get_mpz_t(), image[i].get_mpz_t(),
                  best.denominator.get_mpz_t());
      shift[i] = -shift[i];
    }
    if (r == 0 || compare(image, best.numerator) < 0) {
      best.numerator = std::move(image);
      to_canonical = {static_cast<std::uint8_t>(r), std::move(shift)};
    }
  }
  Integer common = best.denominator;
  for (const Integer& n : best.numerator) common = gcd(common, n);
  for (Integer& n : best.numerator) n /= common;
  best.denominator /= common;
  return {std::move(best), group.invert(to_canonical)};
}

}  // namespace

Orbits make_orbits(const Instance& instance, ElementTable& table) {
  const Group& group = table.group();
  Integer group_denominator = 1;
  for (const Vec<Rational>& t : group.translation) {
    for (const Rational& x : t) group_denominator = lcm(group_denominator, x.get_den());
  }
  const std::size_t n = instance.points.size();
  std::vector<LatticePoint> points(n);
  Orbits orbits;
  orbits.of_point.resize(n);
  orbits.frame.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    Canonical canonical = canonical_point(group, group_denominator, instance.points[i]);
    points[i] = std::move(canonical.point);
    orbits.frame[i] = table.intern(canonical.to_point);
  }

  // Equal points are neighbours after sorting by value, then by index, so each run starts at its least index.
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto equal = [&](std::size_t a, std::size_t b) {
    return points[a].denominator == points[b].denominator && points[a].numerator == points[b].numerator;
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    int c = cmp(points[a].denominator, points[b].denominator);
    if (c == 0) c = compare(points[a].numerator, points[b].numerator);
    return c != 0 ? c < 0 : a < b;
  });
  std::vector<std::size_t> leader(n);
  for (std::size_t k = 0; k < n; ++k) {
    leader[order[k]] = k > 0 && equal(order[k - 1], order[k]) ? leader[order[k - 1]] : order[k];
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (leader[i] == i) {
      orbits.of_point[i] = make_id<OrbitId>(orbits.canonical.size());
      orbits.first_point.push_back(make_id<PointId>(i));
      orbits.canonical.push_back(points[i]);
    } else {
      orbits.of_point[i] = orbits.of_point[leader[i]];  // the leader comes first
    }
  }
  return orbits;
}

}  // namespace flatdt::checker
