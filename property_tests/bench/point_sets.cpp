#include "point_sets.hpp"

#include <cmath>
#include <stdexcept>

#include "../generators/split_mix.hpp"
#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/families.hpp"

namespace flatdt::bench {
namespace {

std::vector<Point> uniform_points(int dimension, std::size_t n, std::uint64_t seed) {
  testing::SplitMix64 random(seed);
  std::vector<Point> points(n, Point{});
  for (Point& p : points)
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
      p[k] = std::ldexp(static_cast<double>(random.next() >> 11), -53);
  return points;
}

/// All of {0, .., k-1}^d, the last coordinate fastest.
template <class Coordinate>
std::vector<Point> grid_points(int dimension, long k, const Coordinate& coordinate) {
  const long planes = dimension == 3 ? k : 1;
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(planes * k * k));
  for (long x = 0; x < k; ++x)
    for (long y = 0; y < k; ++y)
      for (long z = 0; z < planes; ++z) points.push_back({coordinate(x), coordinate(y), coordinate(z)});
  return points;
}

const ref::CatalogueEntry& entry_of(std::string_view manifold) {
  const ref::CatalogueEntry* entry = ref::find_entry(manifold);
  if (entry == nullptr) throw std::invalid_argument("no manifold is called " + std::string(manifold));
  return *entry;
}

ref::Matrix stretched(const ref::Matrix& gram, const std::array<long, 3>& stretch) {
  ref::Matrix result = gram;
  for (int i = 0; i < gram.dimension(); ++i)
    for (int j = 0; j < gram.dimension(); ++j)
      result(i, j) *= ref::Rational(stretch[static_cast<std::size_t>(i)]) *
                      ref::Rational(stretch[static_cast<std::size_t>(j)]);
  return result;
}

void set_points(ref::Instance& instance, const std::vector<Point>& points) {
  instance.points.reserve(points.size());
  for (const Point& p : points) {
    ref::Vector x(instance.dimension);
    for (int k = 0; k < instance.dimension; ++k)
      x[k] = ref::Rational(mpq_class(p[static_cast<std::size_t>(k)]));
    instance.points.push_back(std::move(x));
  }
}

ref::Instance empty_instance(std::string_view manifold) {
  const ref::CatalogueEntry& entry = entry_of(manifold);
  ref::Instance instance;
  instance.dimension = entry.dimension;
  instance.name = entry.name;
  instance.generators = entry.generators;
  instance.gram = entry.canonical_gram;
  return instance;
}

}  // namespace

PointSet point_set(std::string_view name, int dimension, std::size_t n, std::uint64_t seed) {
  const double count = static_cast<double>(n);
  const long k = std::lround(dimension == 3 ? std::cbrt(count) : std::sqrt(count));
  if (name == "uniform") return {dimension, 1, uniform_points(dimension, n, seed)};
  if (name == "rounded-grid")
    return {dimension, 1, grid_points(dimension, k, [k](long i) {
              return static_cast<double>(i) / static_cast<double>(k);
            })};
  if (name == "integer-grid")
    return {dimension, static_cast<double>(k),
            grid_points(dimension, k, [](long i) { return static_cast<double>(i); })};
  throw std::invalid_argument("no point set is called " + std::string(name));
}

ref::Instance torus_instance(const PointSet& set) {
  ref::Instance instance = empty_instance(set.dimension == 2 ? "torus" : "torocosm");
  instance.gram = ref::Matrix::identity(set.dimension);
  instance.generators_given = true;
  instance.generators.clear();
  for (int k = 0; k < set.dimension; ++k) {
    ref::Vector translation(set.dimension);
    translation[k] = ref::Rational(mpq_class(set.period));
    instance.generators.push_back(ref::Isometry::translate(translation));
  }
  set_points(instance, set.points);
  return instance;
}

ref::Instance uniform_instance(std::string_view manifold, std::size_t n, std::uint64_t seed) {
  return stretched_instance(manifold, {1, 1, 1}, n, seed);
}

ref::Instance family_instance(std::string_view manifold, std::string_view family, std::size_t n) {
  return ref::generate(entry_of(manifold), manifold, family, static_cast<long>(n), 1);
}

ref::Instance stretched_instance(std::string_view manifold, const std::array<long, 3>& stretch, std::size_t n,
                                 std::uint64_t seed) {
  ref::Instance instance = empty_instance(manifold);
  instance.gram = stretched(instance.gram, stretch);
  set_points(instance, uniform_points(instance.dimension, n, seed));
  return instance;
}

bool admits_stretch(std::string_view manifold, const std::array<long, 3>& stretch) {
  const ref::CatalogueEntry& entry = entry_of(manifold);
  const ref::Matrix gram = stretched(entry.canonical_gram, stretch);
  for (const ref::Isometry& g : entry.generators)
    if (!ref::preserves_metric(g.linear, gram)) return false;
  return true;
}

}  // namespace flatdt::bench
