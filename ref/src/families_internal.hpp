/// What the families of point sets share: random numbers, the group modulo its lattice, orbits.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string_view>
#include <vector>

#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/instance.hpp"
#include "split_mix.hpp"

namespace flatdt::ref::families_detail {

/// Pseudo-random choices, the same on every machine. An expression draws once: compilers differ in which
/// operand or argument they evaluate first.
class Random {
 public:
  /// Streams of different names are independent for the same seed.
  Random(std::uint64_t seed, std::string_view stream);
  std::uint64_t next() { return numbers_.next(); }
  /// Uniform in [0, bound). Requires: bound > 0.
  std::uint64_t below(std::uint64_t bound);
  /// Uniform in [low, high]. Requires: low <= high.
  long between(long low, long high);
  /// Uniform multiple of 2^-bits in [0,1). Requires: bits < 63.
  Rational dyadic(int bits);
  /// d coordinates dyadic(kCoordinateBits).
  Vector point(int dimension);
  /// d integers, uniform in [low, high].
  Vector integral(int dimension, long low, long high);

 private:
  SplitMix64 numbers_;
};

/// 20 bits: differences, their products and an insphere determinant of such coordinates fit 128 bits.
inline constexpr int kCoordinateBits = 20;

/// 2^-k.
Rational power_of_half(int k);
/// Coordinates modulo 1, in [0,1).
Vector modulo_one(const Vector& x);
/// One element for each linear part, translations in [0,1)^d, the identity first.
/// Requires: the translation lattice of the group is Z^d.
std::vector<Isometry> cosets_of(const std::vector<Isometry>& generators, int dimension);
/// The least m > 0 with R^m = I. Requires: finite order.
int order_of(const Matrix& linear);
/// P_R = (1/m)(I + R + ... + R^(m-1)), the projection on ker(R - I); m the order of R.
Matrix projection_on_fixed(const Matrix& linear);

/// The manifold on which a family puts its points.
struct Setting {
  Setting(const Instance& space_without_points)
      : space(space_without_points),
        dimension(space.dimension),
        cosets(cosets_of(space.generators, dimension)) {}

  const Instance& space;
  int dimension;
  std::vector<Isometry> cosets;
};

/// A set of orbits. Requires: the translation lattice is Z^d and linear parts have entries -1, 0, 1, as in
/// the catalogue.
class Orbits {
 public:
  explicit Orbits(const Setting& setting);
  /// True if the orbit of x is new.
  bool insert(const Vector& x);

 private:
  /// The least point of the orbit, computed in multiples of 1/q.
  [[nodiscard]] Vector least_in_words(const Vector& x, long q) const;

  const Setting& setting_;
  Integer denominator_{1};  // of all translations
  std::set<Vector> seen_;   // the lexicographically least point of each orbit in [0,1)^d
};

/// n points of different orbits, the first that `draw` gives. Throws LimitReached after kMaxRefusals
/// repetitions in a row.
std::vector<Vector> distinct(const Setting& setting, long n, const std::function<Vector()>& draw);
inline constexpr int kMaxRefusals = 10'000;

using Points = std::vector<Vector>;
Points uniform(const Setting&, long n, Random&);
Points lattice(const Setting&, long n, Random&);
Points grid(const Setting&, long n, Random&);
Points on_axis(const Setting&, long n, Random&);
Points on_glide_plane(const Setting&, long n, Random&);
Points cospherical(const Setting&, long n, Random&);
Points near_cospherical(const Setting&, long n, Random&);
Points clustered(const Setting&, long n, Random&);
Points single_orbit(const Setting&, long n, Random&);
Points nearly_duplicate(const Setting&, long n, Random&);
Points far_from_cell(const Setting&, long n, Random&);
Points moment_curve(const Setting&, long n, Random&);

/// A random Gram matrix that all linear parts of `cosets` preserve exactly, near `canonical`.
Matrix random_gram(const Matrix& canonical, const std::vector<Isometry>& cosets, Random& random);
/// The Gram matrix with axes stretched by factors from 1 to 10, 30, 100, 300 or 1000; axes that the group
/// mixes get one factor, so invariance stays exact.
Matrix stretched_gram(const Matrix& gram, const std::vector<Isometry>& cosets, Random& random);
/// The same space and points in the basis of the columns of a random unimodular matrix.
Instance in_skew_basis(const Instance& instance, Random& random);

}  // namespace flatdt::ref::families_detail
