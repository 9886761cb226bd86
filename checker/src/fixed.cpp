#include "fixed.hpp"

#include <numeric>

namespace flatdt::checker {
namespace {

/// The least common multiple of a and b, if it is below kFixedLimit.   Requires: a, b > 0.
std::optional<std::int64_t> common_multiple(std::int64_t a, const Integer& b) {
  const std::optional<std::int64_t> other = to_fixed(b);
  if (!other) return std::nullopt;
  if (a % *other == 0) return a;
  const Int128 multiple = static_cast<Int128>(a / std::gcd(a, *other)) * *other;
  if (multiple >= kFixedLimit) return std::nullopt;
  return static_cast<std::int64_t>(multiple);
}

/// factor x, if it is an integer below kFixedLimit in absolute value.   Requires: factor x is an integer.
std::optional<std::int64_t> scaled(const Rational& x, std::int64_t factor) {
  const std::optional<std::int64_t> numerator = to_fixed(x.get_num());
  if (!numerator) return std::nullopt;
  const Int128 value = static_cast<Int128>(*numerator) * (factor / x.get_den().get_si());
  if (value >= kFixedLimit || value <= -kFixedLimit) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

}  // namespace

std::optional<std::int64_t> to_fixed(const Integer& x) {
  if (!x.fits_slong_p()) return std::nullopt;
  const std::int64_t value = x.get_si();
  if (value >= kFixedLimit || value <= -kFixedLimit) return std::nullopt;
  return value;
}

// With the points over a common denominator a and basis_inverse over b, lattice coordinates have the
// denominator a b.
std::optional<FixedPoints> fixed_points(const Instance& instance, const Group& group) {
  const auto d = static_cast<std::size_t>(instance.dimension);
  std::optional<std::int64_t> a = 1;
  for (const Vec<Rational>& point : instance.points) {
    for (std::size_t i = 0; i < d && a; ++i) a = common_multiple(*a, point[i].get_den());
    if (!a) return std::nullopt;
  }
  std::optional<std::int64_t> b = 1;
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = 0; j < d && b; ++j) b = common_multiple(*b, group.basis_inverse[i][j].get_den());
  }
  if (!b || static_cast<Int128>(*a) * *b >= kFixedLimit) return std::nullopt;
  std::optional<std::int64_t> denominator = *a * *b;
  for (const Vec<Rational>& t : group.translation) {
    for (std::size_t i = 0; i < d && denominator; ++i) {
      denominator = common_multiple(*denominator, t[i].get_den());
    }
  }
  if (!denominator) return std::nullopt;
  Mat<std::int64_t> to_lattice{};  // takes points over a to lattice coordinates over the denominator
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = 0; j < d; ++j) {
      const std::optional<std::int64_t> entry = scaled(group.basis_inverse[i][j], *denominator / *a);
      if (!entry) return std::nullopt;
      to_lattice[i][j] = *entry;
    }
  }
  FixedPoints points;
  points.denominator = *denominator;
  points.numerator.reserve(instance.points.size());
  for (const Vec<Rational>& point : instance.points) {
    Vec<std::int64_t> outer{};
    for (std::size_t i = 0; i < d; ++i) {
      const std::optional<std::int64_t> x = scaled(point[i], *a);
      if (!x) return std::nullopt;
      outer[i] = *x;
    }
    Vec<std::int64_t>& inner = points.numerator.emplace_back();
    for (std::size_t i = 0; i < d; ++i) {
      Int128 sum = 0;  // three products below 2^122
      for (std::size_t j = 0; j < d; ++j) sum += static_cast<Int128>(to_lattice[i][j]) * outer[j];
      if (sum >= kFixedLimit || sum <= -kFixedLimit) return std::nullopt;
      inner[i] = static_cast<std::int64_t>(sum);
    }
  }
  return points;
}

std::optional<FixedMap> fixed_map(const Group& group, const Element& element, std::int64_t denominator,
                                  std::int64_t most) {
  FixedMap map{element.rotation == 0, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<std::int64_t> shift = to_fixed(element.shift[i]);
    const std::optional<std::int64_t> t = scaled(group.translation[element.rotation][i], denominator);
    if (!shift || !t) return std::nullopt;
    Int128 bound = 0;  // of the image: at most three products below 2^122 and a sum below 2^123
    for (std::size_t j = 0; j < 3; ++j) {
      const std::optional<std::int64_t> entry = to_fixed(group.linear[element.rotation][i][j]);
      if (!entry) return std::nullopt;
      map.linear[i][j] = *entry;
      bound += static_cast<Int128>(*entry < 0 ? -*entry : *entry) * most;
    }
    const Int128 translation = static_cast<Int128>(*shift) * denominator + *t;
    bound += translation < 0 ? -translation : translation;
    if (bound >= kFixedLimit) return std::nullopt;
    map.translation[i] = static_cast<std::int64_t>(translation);
  }
  return map;
}

}  // namespace flatdt::checker
