#include "point_families.hpp"

#include <array>

namespace flatdt::campaign {
namespace {

using ref::Integer;
using ref::Rational;
using ref::Vector;
using testing::Random;

constexpr long kFine = 1L << 20;

Rational power_of_half(long k) {
  return {Integer(1), Integer(1L << k)};
}

Rational uniform(Random& random) {
  return random.fraction(0, kFine - 1, kFine);
}

long power(long m, int d) {
  return d == 2 ? m * m : m * m * m;
}

std::vector<Vector> thin_band(int d, long n, Random& random) {
  const int axis = static_cast<int>(random.below(static_cast<std::uint64_t>(d)));
  const Rational width = power_of_half(random.between(2, 40));
  const Rational place = random.one_in(2) ? Rational(0) : random.fraction(0, 63, 64);
  std::vector<Vector> points;
  for (long i = 0; i < n; ++i) {
    Vector x(d);
    for (int k = 0; k < d; ++k) x[k] = uniform(random);
    x[axis] = place + width * uniform(random);
    points.push_back(x);
  }
  return points;
}

/// The places of (1/m)Z^d in one cell, in random order.
std::vector<Vector> grid(int d, long m, Random& random) {
  std::vector<Vector> places;
  for (long code = 0; code < power(m, d); ++code) {
    Vector x(d);
    long rest = code;
    for (int k = 0; k < d; ++k, rest /= m) x[k] = Rational(Integer(rest % m), Integer(m));
    places.push_back(x);
  }
  random.shuffle(places);
  return places;
}

/// Each coordinate moved by -2, ..., 2 times 2^-k.
void jitter(std::vector<Vector>& points, Random& random) {
  const Rational step = power_of_half(random.between(3, 48));
  for (Vector& x : points)
    for (int k = 0; k < x.dimension(); ++k) x[k] += Rational(random.between(-2, 2)) * step;
}

std::vector<Vector> jittered_grid(int d, long n, Random& random) {
  long m = 1;
  while (power(m, d) < n) ++m;
  std::vector<Vector> points = grid(d, m, random);
  points.resize(static_cast<std::size_t>(n), Vector(d));
  jitter(points, random);
  return points;
}

std::vector<Vector> filled_grid(int d, long n, Random& random) {
  long m = 1;
  while (power(m + 1, d) <= n) ++m;
  std::vector<Vector> points = grid(d, m, random);
  if (!random.one_in(4)) jitter(points, random);
  while (static_cast<long>(points.size()) < n) {
    Vector x(d);
    for (int k = 0; k < d; ++k) x[k] = uniform(random);
    points.push_back(x);
  }
  if (random.one_in(2)) random.shuffle(points);
  return points;
}

std::vector<Vector> integer_grid(int d, long n, Random& random) {
  long m = 1;
  while (power(m, d) < n) ++m;
  m += random.between(0, 4);
  if (random.one_in(2))
    while ((m & (m - 1)) != 0) ++m;
  std::vector<Vector> points = grid(d, m, random);
  while (static_cast<long>(points.size()) > n) points.pop_back();
  return points;
}

}  // namespace

const std::vector<std::string>& own_families() {
  static const std::vector<std::string> kFamilies{"thin-band", "jittered-grid", "filled-grid",
                                                  "integer-grid"};
  return kFamilies;
}

std::vector<Vector> draw_points(const std::string& family, int dimension, long n, Random& random) {
  if (family == "thin-band") return thin_band(dimension, n, random);
  if (family == "jittered-grid") return jittered_grid(dimension, n, random);
  if (family == "filled-grid") return filled_grid(dimension, n, random);
  return integer_grid(dimension, n, random);
}

}  // namespace flatdt::campaign
