#include "families_internal.hpp"

#include <algorithm>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::families_detail {

Random::Random(std::uint64_t seed, std::string_view stream) : state_(seed) {
  // FNV-1a of the name, so that streams of one seed start at unrelated places.
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : stream) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  state_ = next() ^ hash;
}

std::uint64_t Random::next() {
  state_ += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
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

bool Orbits::insert(const Vector& x) {
  Vector least = modulo_one(x);
  for (const Isometry& g : setting_.cosets) least = std::min(least, modulo_one(g * x));
  return seen_.insert(least).second;
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
