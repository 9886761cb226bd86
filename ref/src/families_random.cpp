/// Families of independent points: uniform, clustered, in pairs, far away; and representatives of one orbit.
#include <algorithm>

#include "families_internal.hpp"

namespace flatdt::ref::families_detail {
namespace {

const Isometry& random_coset(const Setting& setting, Random& random) {
  return setting.cosets[random.below(setting.cosets.size())];
}

}  // namespace

Points uniform(const Setting& setting, long n, Random& random) {
  return distinct(setting, n, [&] { return random.point(setting.dimension); });
}

Points clustered(const Setting& setting, long n, Random& random) {
  struct Cluster {
    Vector corner;
    Rational width;
  };
  std::vector<Cluster> clusters;
  for (long k = 0; k * k < n; ++k)
    clusters.push_back(
        {random.point(setting.dimension), power_of_half(static_cast<int>(random.between(4, 12)))});
  return distinct(setting, n, [&] {
    const Cluster& cluster = clusters[random.below(clusters.size())];
    return modulo_one(cluster.corner + cluster.width * random.point(setting.dimension));
  });
}

Points nearly_duplicate(const Setting& setting, long n, Random& random) {
  Vector last(setting.dimension);
  bool second = false;
  return distinct(setting, n, [&] {
    second = !second;
    if (second) return last = random.point(setting.dimension);
    Vector near = last;
    const int axis = static_cast<int>(random.below(static_cast<std::uint64_t>(setting.dimension)));
    const Rational step = power_of_half(static_cast<int>(random.between(20, 60)));
    near[axis] += random.below(2) == 0 ? step : -step;
    return modulo_one(random_coset(setting, random) * near);
  });
}

Points far_from_cell(const Setting& setting, long n, Random& random) {
  return distinct(setting, n, [&] {
    const Vector point = random.point(setting.dimension);
    const Vector x = random_coset(setting, random) * point;
    const long reach = 1L << random.between(10, 50);
    return x + random.integral(setting.dimension, -reach, reach);
  });
}

Points single_orbit(const Setting& setting, long n, Random& random) {
  const Vector x = random.point(setting.dimension);
  // At least 4 n lattice translations: random representatives are usually new.
  long reach = 1;
  while ((2 * reach + 1) * (2 * reach + 1) < 4 * n) reach *= 2;
  std::set<Vector> seen = {x};
  Points points = {x};
  while (points.size() < static_cast<std::size_t>(n)) {
    const Vector shift = random.integral(setting.dimension, -reach, reach);
    const Vector y = random_coset(setting, random) * x + shift;
    if (seen.insert(y).second) points.push_back(y);
  }
  return points;
}

}  // namespace flatdt::ref::families_detail
