/// Moves of points. Source of the kinds: where exact algorithms fail - ties, near ties, orbits that meet
/// their own images symmetrically.
#include <array>

#include "flatdt/ref/errors.hpp"
#include "moves.hpp"

namespace flatdt::fuzz {
namespace {

using ref::Integer;
using ref::Isometry;
using ref::Matrix;
using ref::Rational;
using ref::Vector;

const Rational kHalf(Integer(1), Integer(2));

Vector random_orbit_point(const Specimen& specimen, Random& random) {
  const Vector& point = specimen.points[random.index(specimen.points.size())];
  return random_element(specimen, random) * point;
}

/// The centre of the sphere through d+1 points of orbits: 2 A G c = q in coordinates relative to the first,
/// rows of A the differences. Nothing if they lie in a hyperplane.
std::optional<Vector> circumcentre(const Specimen& specimen, Random& random) {
  const int d = specimen.dimension();
  const Matrix gram = metric_of(specimen);
  const Vector first = random_orbit_point(specimen, random);
  Matrix differences(d);
  Vector squares(d);
  for (int k = 0; k < d; ++k) {
    const Vector difference = random_orbit_point(specimen, random) - first;
    for (int i = 0; i < d; ++i) differences(k, i) = difference[i];
    squares[k] = ref::squared_length(gram, difference);
  }
  const Matrix system = differences * gram;
  if (system.determinant().is_zero()) return std::nullopt;
  return first + kHalf * (system.inverse() * squares);
}

/// The nearest point to x on the axis or plane that g moves within itself: the mean of the images of x under
/// the powers of g, each without the part of the motion along it.
Vector on_axis(const Isometry& g, const Vector& x) {
  const int d = g.dimension();
  std::array<Vector, 6> images{Vector(d), Vector(d), Vector(d), Vector(d), Vector(d), Vector(d)};
  // The order of the linear part: 1, 2, 3, 4 or 6 in a crystal. Otherwise six images are averaged, to no
  // effect.
  int order = 0;
  Isometry power = Isometry::identity(d);
  Vector along(d);
  do {
    images[static_cast<std::size_t>(order)] = power * x;
    power = g * power;
    ++order;
  } while (order < 6 && !power.linear.is_identity());
  along = Rational(Integer(1), Integer(order)) * power.translation;
  Vector sum(d);
  for (int k = 0; k < order; ++k) sum = sum + images[static_cast<std::size_t>(k)] - Rational(k) * along;
  return Rational(Integer(1), Integer(order)) * sum;
}

bool add_point(Specimen& specimen, const Vector& x) {
  if (specimen.points.size() >= kMaxPoints) return false;
  specimen.points.push_back(x);
  return true;
}

bool remove_point(Specimen& specimen, Random& random) {
  if (specimen.points.size() < 2) return false;
  const std::size_t gone = random.index(specimen.points.size());
  specimen.points.erase(specimen.points.begin() + static_cast<std::ptrdiff_t>(gone));
  for (CodedCell& cell : specimen.cells)
    for (CodedVertex& v : cell) v.point = static_cast<std::uint8_t>(v.point % specimen.points.size());
  for (CodedQuery& query : specimen.queries)
    query.point = static_cast<std::uint8_t>(query.point % specimen.points.size());
  return true;
}

/// A new place for the point x.
std::optional<Vector> place(const Specimen& specimen, const Vector& x, Random& random) {
  const int d = specimen.dimension();
  Vector y = x;
  const auto i = random.below(d);
  switch (random.below(12)) {
    case 0:
      for (int k = 0; k < d; ++k) y[k] = simple_rational(random);
      return y;
    case 1:
      y[i] = simple_rational(random);
      return y;
    case 2:
      y[i] += tiny_rational(random);
      return y;
    case 3:
      y[i] = y[random.below(d)];
      return y;
    case 4:  // another representative of its orbit
      return random_element(specimen, random) * x;
    case 5:  // the midpoint of two points of orbits
      y = random_orbit_point(specimen, random);
      return kHalf * (y + random_orbit_point(specimen, random));
    case 6:  // the other end of a diameter of a circumsphere
    case 7:
      if (const auto centre = circumcentre(specimen, random))
        return Rational(2) * *centre - random_orbit_point(specimen, random);
      return std::nullopt;
    case 8:
      return circumcentre(specimen, random);
    case 9:
      return on_axis(random_element(specimen, random), x);
    case 10: {  // 2^-k beside an image of a point
      y = random_orbit_point(specimen, random);
      y[i] += tiny_rational(random);
      return y;
    }
    default: {  // onto the grid of thirds, quarters, .. next to it
      const Rational step(Integer(1), Integer(2 + random.below(11)));
      for (int k = 0; k < d; ++k) y[k] = step * Rational(round_half_up(y[k] / step));
      return y;
    }
  }
}

}  // namespace

Rational simple_rational(Random& random) {
  const int denominator = 1 + random.below(random.one_in(4) ? 100 : 12);
  return {Integer(random.below(2 * denominator + 1) - denominator / 2), Integer(denominator)};
}

Rational tiny_rational(Random& random) {
  const Rational size(Integer(1), Integer(1L << (1 + random.below(61))));
  return random.one_in(2) ? size : -size;
}

Vector in_dimension(const Vector& v, int dimension) {
  Vector result(dimension);
  for (int i = 0; i < std::min(dimension, v.dimension()); ++i) result[i] = v[i];
  return result;
}

Isometry random_element(const Specimen& specimen, Random& random) {
  const int d = specimen.dimension();
  if (const NamedGroup* group = specimen.named()) {
    Isometry g = group->cosets[random.index(group->cosets.size())];
    for (int i = 0; i < d; ++i) g.translation[i] += Rational(random.below(3) - 1);
    return g;
  }
  Isometry g = Isometry::identity(d);
  for (int length = random.below(4); length > 0; --length) {
    const Isometry& factor = specimen.generators[random.index(specimen.generators.size())];
    const bool backwards = random.one_in(2) && !factor.linear.determinant().is_zero();
    g = g * (backwards ? factor.inverse() : factor);
  }
  return g;
}

bool move_point(Specimen& specimen, Random& random) {
  switch (random.below(8)) {
    case 0:
      return remove_point(specimen, random);
    case 1: {
      Vector& point = specimen.points[random.index(specimen.points.size())];
      std::swap(point, specimen.points[random.index(specimen.points.size())]);
      return true;
    }
    case 2:
    case 3: {
      const auto x = place(specimen, random_orbit_point(specimen, random), random);
      return x && add_point(specimen, *x);
    }
    default: {
      Vector& x = specimen.points[random.index(specimen.points.size())];
      const auto y = place(specimen, x, random);
      if (!y) return false;
      x = *y;
      return true;
    }
  }
}

}  // namespace flatdt::fuzz
