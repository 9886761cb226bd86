#include "families_internal.hpp"

#include <algorithm>
#include <array>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::families_detail {
namespace {

constexpr std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

Random::Random(std::uint64_t seed, std::string_view stream) : numbers_(seed) {
  // FNV-1a of the name, so that streams of one seed start at unrelated places.
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : stream) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  numbers_ = SplitMix64(next() ^ hash);
}

std::uint64_t Random::below(std::uint64_t bound) {
  ensure(bound > 0, "a random number below a positive bound");
  // Numbers under 2^64 mod bound are refused: what is left has a multiple of bound elements.
  const std::uint64_t refused = (std::uint64_t{0} - bound) % bound;
  std::uint64_t value = next();
  while (value < refused) value = next();
  return value % bound;
}

long Random::between(long low, long high) {
  return low + static_cast<long>(below(static_cast<std::uint64_t>(high - low) + 1));
}

Rational Random::dyadic(int bits) {
  return Rational(static_cast<long>(below(std::uint64_t{1} << bits))) * power_of_half(bits);
}

Vector Random::point(int dimension) {
  Vector x(dimension);
  for (int i = 0; i < dimension; ++i) x[i] = dyadic(kCoordinateBits);
  return x;
}

Vector Random::integral(int dimension, long low, long high) {
  Vector x(dimension);
  for (int i = 0; i < dimension; ++i) x[i] = between(low, high);
  return x;
}

Rational power_of_half(int k) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 2, static_cast<unsigned long>(k));
  return {Integer(1), Integer(power)};
}

Vector modulo_one(const Vector& x) {
  Vector y = x;
  for (int i = 0; i < y.dimension(); ++i) y[i] -= Rational(floor(y[i]));
  return y;
}

std::vector<Isometry> cosets_of(const std::vector<Isometry>& generators, int dimension) {
  std::vector<Isometry> cosets = {Isometry::identity(dimension)};
  for (std::size_t done = 0; done < cosets.size(); ++done) {
    for (const Isometry& g : generators) {
      Isometry product = g * cosets[done];
      product.translation = modulo_one(product.translation);
      const auto same_linear = [&](const Isometry& h) { return h.linear == product.linear; };
      if (std::none_of(cosets.begin(), cosets.end(), same_linear)) cosets.push_back(product);
    }
  }
  return cosets;
}

int order_of(const Matrix& linear) {
  int order = 1;
  for (Matrix power = linear; !power.is_identity(); power = power * linear) ++order;
  return order;
}

Matrix projection_on_fixed(const Matrix& linear) {
  const int order = order_of(linear);
  Matrix sum(linear.dimension()), power = Matrix::identity(linear.dimension());
  for (int i = 0; i < order; ++i, power = power * linear) sum = sum + power;
  return Rational(Integer(1), Integer(order)) * sum;
}

Orbits::Orbits(const Setting& setting) : setting_(setting) {
  for (const Isometry& g : setting.cosets)
    for (int i = 0; i < setting.dimension; ++i)
      denominator_ = lcm(denominator_, g.translation[i].denominator());
}

bool Orbits::insert(const Vector& x) {
  // Almost always the coordinates have a short common denominator q: then the images are computed in
  // multiples of 1/q in machine words, several times faster (entries of linear parts are -1, 0 and 1: sums
  // stay below 4q).
  Integer common = denominator_;
  for (int i = 0; i < setting_.dimension; ++i) common = lcm(common, x[i].denominator());
  if (common.bits() <= 60) return seen_.insert(least_in_words(x, common.to_long())).second;
  Vector least = modulo_one(x);
  for (const Isometry& g : setting_.cosets) least = std::min(least, modulo_one(g * x));
  return seen_.insert(least).second;
}

Vector Orbits::least_in_words(const Vector& x, long q) const {
  using Words = std::array<long, kMaxDimension>;
  const int d = setting_.dimension;
  const auto in_words = [q](const Rational& r) {
    return floor_mod(r.numerator() * exact_div(Integer(q), r.denominator()), Integer(q)).to_long();
  };
  Words start{}, least{};
  for (int i = 0; i < d; ++i) least[index(i)] = start[index(i)] = in_words(x[i]);
  for (const Isometry& g : setting_.cosets) {
    Words image{};
    for (int i = 0; i < d; ++i) {
      long sum = in_words(g.translation[i]);
      for (int j = 0; j < d; ++j) sum += sgn(g.linear(i, j).mpq()) * start[index(j)];
      image[index(i)] = (sum % q + q) % q;
    }
    least = std::min(least, image);
  }
  Vector point(d);
  for (int i = 0; i < d; ++i) point[i] = Rational(Integer(least[index(i)]), Integer(q));
  return point;
}

std::vector<Vector> distinct(const Setting& setting, long n, const std::function<Vector()>& draw) {
  Orbits orbits(setting);
  std::vector<Vector> points;
  int refused = 0;
  while (points.size() < static_cast<std::size_t>(n)) {
    const Vector x = draw();
    if (orbits.insert(x)) {
      points.push_back(x);
      refused = 0;
    } else if (++refused > kMaxRefusals) {
      throw LimitReached("this family has no " + std::to_string(n) + " points in different orbits");
    }
  }
  return points;
}

}  // namespace flatdt::ref::families_detail
