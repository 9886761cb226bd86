/// Families in special position: lattices, grids, fixed lines and planes, spheres, the moment curve.
#include <algorithm>

#include "families_internal.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::ref::families_detail {
namespace {

/// A line or a plane that an element g translates along itself: g x = x + advance for its points.
struct FixedSpace {
  Vector point;       // one of its points
  Vector advance;     // P_R t
  Matrix projection;  // P_R: its directions
};

/// For g = {R|t}: x with (I - R) x = t - P_R t =: u is -(1/m) sum of i R^i u over 0 <= i < m, because
/// (I - R) (sum of i R^i) = m P_R - m I and P_R u = 0.
FixedSpace fixed_space(const Isometry& g) {
  const int order = order_of(g.linear);
  const Matrix projection = projection_on_fixed(g.linear);
  const Vector advance = projection * g.translation;
  Vector power = g.translation - advance, sum(g.dimension());
  for (int i = 0; i < order; ++i, power = g.linear * power) sum = sum + Rational(i) * power;
  return {Rational(Integer(-1), Integer(order)) * sum, advance, projection};
}

/// Coset representatives whose linear part is not the identity and has this determinant.
std::vector<Isometry> elements_of_sign(const Setting& setting, Sign determinant) {
  std::vector<Isometry> list;
  for (const Isometry& g : setting.cosets)
    if (!g.linear.is_identity() && g.linear.determinant().sign() == determinant) list.push_back(g);
  return list;
}

/// A random element of the list times a short lattice translation.
Isometry random_element(const std::vector<Isometry>& list, Random& random) {
  Isometry g = list[random.below(list.size())];
  g.translation = g.translation + random.integral(g.dimension(), 0, 1);
  return g;
}

/// Enough bits for n random points on a line to be mostly different.
int bits_on_line(long n) {
  int bits = kCoordinateBits;
  while ((1L << bits) < 64 * n) ++bits;
  return bits;
}

/// A point p with 0 < |p|^2 <= delta^2 / 8: spheres of that radius around an orbit have disjoint insides.
Vector short_radius(const Setting& setting, Random& random) {
  Instance space = setting.space;
  space.points = {Vector(setting.dimension)};
  const Rational bound = analyse(space).frame.delta_squared * power_of_half(3);
  Vector p(setting.dimension);
  while (p.is_zero()) p = random.integral(setting.dimension, -4, 4);
  while (squared_length(setting.space.gram, p) > bound) p = power_of_half(1) * p;
  return p;
}

/// Random points of the sphere around 0 through p: mirror images of p in the hyperplanes orthogonal to short
/// integral vectors. Every rational point of the sphere is such an image.
class Sphere {
 public:
  Sphere(const Setting& setting, long n, Random& random)
      : gram_(setting.space.gram), radius_(short_radius(setting, random)), reach_(4) {
    while (4 * reach_ * reach_ < 32 * n) reach_ *= 2;
  }
  Vector point(Random& random) const {
    Vector normal(radius_.dimension());
    while (normal.is_zero()) normal = random.integral(radius_.dimension(), -reach_, reach_);
    const Rational factor = inner_product(gram_, radius_, normal) / inner_product(gram_, normal, normal);
    return radius_ - Rational(2) * factor * normal;
  }

 private:
  Matrix gram_;
  Vector radius_;
  long reach_;
};

/// A centre with short coordinates: multiples of 1/64.
Vector random_centre(const Setting& setting, Random& random) {
  return power_of_half(6) * random.integral(setting.dimension, 0, 63);
}

}  // namespace

Points lattice(const Setting& setting, long n, Random& random) {
  // m = n * holonomy order multiples of v/m are different modulo Z^d because v[0] = 1, so they meet n orbits.
  const long m = n * static_cast<long>(setting.cosets.size());
  Vector v = random.integral(setting.dimension, 0, m - 1);
  v[0] = 1;
  long i = 0;
  return distinct(setting, n, [&] { return modulo_one(Rational(Integer(i++), Integer(m)) * v); });
}

Points grid(const Setting& setting, long n, Random& random) {
  const auto power = [&](long m) { return setting.dimension == 2 ? m * m : m * m * m; };
  long m = 1;
  while (power(m) < n * static_cast<long>(setting.cosets.size())) ++m;
  // i -> a i + b modulo m^d runs through all grid points in an irregular order without a table.
  const long count = power(m);
  long a = random.between(1, count);
  while (gcd(Integer(a), Integer(count)) != Integer(1)) a = random.between(1, count);
  Integer index(random.between(0, count - 1));
  return distinct(setting, n, [&] {
    index = floor_mod(index + Integer(a), Integer(count));
    Integer rest = index;
    Vector x(setting.dimension);
    for (int k = 0; k < setting.dimension; ++k) {
      x[k] = Rational(floor_mod(rest, Integer(m)), Integer(m));
      rest = floor_div(rest, Integer(m));
    }
    return x;
  });
}

Points on_axis(const Setting& setting, long n, Random& random) {
  std::vector<Isometry> elements = elements_of_sign(setting, Sign::positive);
  if (elements.empty()) elements = elements_of_sign(setting, Sign::negative);
  const int bits = bits_on_line(n);
  return distinct(setting, n, [&] {
    if (elements.empty()) {  // a torus
      Vector x(setting.dimension);
      x[static_cast<int>(random.below(static_cast<std::uint64_t>(setting.dimension)))] = random.dyadic(bits);
      return x;
    }
    const FixedSpace axis = fixed_space(random_element(elements, random));
    return modulo_one(axis.point + random.dyadic(bits) * axis.advance);
  });
}

Points on_glide_plane(const Setting& setting, long n, Random& random) {
  const std::vector<Isometry> elements = elements_of_sign(setting, Sign::negative);
  const int axis = static_cast<int>(random.below(static_cast<std::uint64_t>(setting.dimension)));
  const int bits = bits_on_line(n);
  return distinct(setting, n, [&] {
    Vector x(setting.dimension);
    for (int k = 0; k < setting.dimension; ++k) x[k] = random.dyadic(bits);
    if (elements.empty()) {
      x[axis] = Rational(random.between(0, 1)) * power_of_half(1);
      return x;
    }
    const FixedSpace plane = fixed_space(random_element(elements, random));
    return modulo_one(plane.point + plane.projection * x);
  });
}

Points cospherical(const Setting& setting, long n, Random& random) {
  const Sphere sphere(setting, n, random);
  const Vector centre = random_centre(setting, random);
  return distinct(setting, n, [&] { return centre + sphere.point(random); });
}

Points near_cospherical(const Setting& setting, long n, Random& random) {
  const Sphere sphere(setting, n, random);
  const Vector centre = random_centre(setting, random);
  int k = 7;
  return distinct(setting, n, [&] {
    k = k == 60 ? 8 : k + 1;
    const Rational step = power_of_half(k);
    const Vector on_sphere = sphere.point(random);
    return centre + (Rational(1) + (random.below(2) == 0 ? step : -step)) * on_sphere;
  });
}

Points moment_curve(const Setting& setting, long n, Random& random) {
  long m = 1;
  while (m < n) m *= 2;
  for (int attempt = 0; attempt < 64; ++attempt) {
    const Vector corner = random.point(setting.dimension);
    Orbits orbits(setting);
    Points points;
    bool all_new = true;
    for (long i = 0; i < n && all_new; ++i) {
      const Rational t = Rational(i) / Rational(m);
      Vector x(setting.dimension);
      Rational power = power_of_half(2);
      for (int k = 0; k < setting.dimension; ++k) x[k] = power = power * t;
      points.push_back(corner + x);
      all_new = orbits.insert(points.back());
    }
    // A corner at which two points of the curve are equivalent is rare: take another one.
    if (all_new) return points;
  }
  throw InternalError("some piece of the moment curve has points of different orbits");
}

}  // namespace flatdt::ref::families_detail
