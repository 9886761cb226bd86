#include "flatdt/testing/draw.hpp"

#include <algorithm>
#include <numeric>

#include "flatdt/ref/families.hpp"
#include "metrics.hpp"
#include "random.hpp"

namespace flatdt::testing {
namespace {

using ref::Integer;
using ref::Isometry;
using ref::Matrix;
using ref::Rational;
using ref::Vector;

/// An element of the group: a product of a coset representative and a translation by at most `reach`.
Isometry draw_element(const std::vector<Isometry>& cosets, long reach, Random& random) {
  const Isometry& coset = random.of(cosets);
  Vector t(coset.dimension());
  for (int i = 0; i < t.dimension(); ++i) t[i] = random.between(-reach, reach);
  return Isometry::translate(t) * coset;
}

std::vector<Vector> small_grid(int d, long n, Random& random) {
  const long m = random.between(1, 6);
  std::vector<Vector> points;
  for (long i = 0; i < n; ++i) {
    Vector x(d);
    for (int k = 0; k < d; ++k) x[k] = random.fraction(0, m - 1, m);
    points.push_back(x);
  }
  return points;
}

/// Points between one point and its images: they lie in the middle of an edge, of a cell or on an axis.
std::vector<Vector> midpoints(const std::vector<Isometry>& cosets, long n, Random& random) {
  std::vector<Vector> points = small_grid(cosets.front().dimension(), 1, random);
  if (random.one_in(2)) points[0][0] = random.fraction(0, 96, 97);
  while (static_cast<long>(points.size()) < n) {
    const Vector& x = points[random.below(points.size())];
    points.push_back(Rational(Integer(1), Integer(2)) * (x + draw_element(cosets, 1, random) * x));
  }
  return points;
}

/// The same group by other generators: products, inverses, redundant ones, another order.
std::vector<Isometry> other_generators(std::vector<Isometry> generators, Random& random) {
  for (int moves = 0; moves < 4; ++moves) {
    const std::size_t i = random.below(generators.size());
    const std::size_t j = random.below(generators.size());
    if (i != j) generators[i] = generators[i] * generators[j];
    if (random.one_in(2)) generators[j] = generators[j].inverse();
  }
  if (random.one_in(3)) {
    const Isometry second = random.of(generators);
    generators.push_back(random.of(generators) * second);
  }
  random.shuffle(generators);
  return generators;
}

/// A product of shears, a permutation with signs, and sometimes a rational diagonal matrix.
Matrix draw_basis(int d, Random& random) {
  Matrix basis = Matrix::identity(d);
  if (random.one_in(2))
    for (int round = 0; round < 3; ++round) {
      Matrix shear = Matrix::identity(d);
      const int i = static_cast<int>(random.below(static_cast<std::uint64_t>(d)));
      const int j = (i + 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(d) - 1))) % d;
      shear(i, j) = random.between(-5, 5);
      basis = basis * shear;
    }
  if (random.one_in(2)) {
    std::vector<int> axes(static_cast<std::size_t>(d));
    std::iota(axes.begin(), axes.end(), 0);
    random.shuffle(axes);
    Matrix permutation(d);
    for (int i = 0; i < d; ++i) permutation(i, axes[static_cast<std::size_t>(i)]) = random.one_in(2) ? -1 : 1;
    basis = basis * permutation;
  }
  if (random.one_in(3)) {
    Matrix diagonal(d);
    for (int i = 0; i < d; ++i) diagonal(i, i) = random.fraction(1, 7, random.between(1, 7));
    basis = basis * diagonal;
  }
  return basis;
}

Vector draw_origin(int d, Random& random) {
  Vector origin(d);
  const long denominator = random.one_in(2) ? random.between(1, 12) : 1000003;
  for (int i = 0; i < d; ++i) origin[i] = random.fraction(-3 * denominator, 3 * denominator, denominator);
  return origin;
}

std::vector<Vector> draw_points(const Specimen& space, const std::string& rule,
                                const std::vector<Isometry>& cosets, long n, Random& random) {
  if (rule == kSmallGridRule) return small_grid(space.dimension(), n, random);
  if (rule == kMidpointRule) return midpoints(cosets, n, random);
  // Of these two families the metric and the basis are special, not the points; draw_specimen makes such
  // metrics and bases itself.
  const bool plain = rule == "long-cell" || rule == "skew-basis";
  return ref::generate(*space.entry, name_of(space), plain ? "uniform" : rule, n, random.next()).points;
}

}  // namespace

std::vector<std::string> manifolds_of_the_plane() {
  std::vector<std::string> names;
  for (const ref::CatalogueEntry& entry : ref::catalogue())
    if (entry.dimension == 2) names.push_back(entry.name);
  return names;
}

std::vector<std::string> manifolds_of_space() {
  std::vector<std::string> names, mirror_images;
  for (const ref::CatalogueEntry& entry : ref::catalogue()) {
    if (entry.dimension != 3) continue;
    names.push_back(entry.name);
    mirror_images.insert(mirror_images.end(), entry.mirror_aliases.begin(), entry.mirror_aliases.end());
  }
  names.insert(names.end(), mirror_images.begin(), mirror_images.end());
  return names;
}

std::vector<std::string> all_manifolds() {
  std::vector<std::string> names = manifolds_of_the_plane();
  const std::vector<std::string> space = manifolds_of_space();
  names.insert(names.end(), space.begin(), space.end());
  return names;
}

std::vector<std::string> point_rules() {
  std::vector<std::string> rules;
  for (const ref::Family& family : ref::families()) rules.push_back(family.name);
  rules.emplace_back(kSmallGridRule);
  rules.emplace_back(kMidpointRule);
  return rules;
}

Specimen draw_specimen(const Domain& domain, std::uint64_t seed, int size) {
  Random random(seed);
  Specimen specimen = empty_specimen(random.of(domain.manifolds));
  const int d = specimen.dimension();
  const std::vector<Isometry> cosets = cosets_of(specimen.generators);
  const std::vector<std::string> rules = domain.rules.empty() ? point_rules() : domain.rules;
  specimen.family = random.of(rules);
  const long most = 1 + (domain.max_points(d) - 1) * std::clamp(size, 0, 100) / 100;
  const long n = random.between(domain.min_points, most);
  const long max_stretch = d == 2 ? domain.max_stretch_in_plane : domain.max_stretch_in_space;
  if (domain.other_metrics)
    specimen.gram = specimen.family == "long-cell"
                        ? stretched_metric(specimen.gram, cosets, max_stretch, random)
                        : draw_metric(specimen.gram, cosets, max_stretch, random);
  specimen.points = draw_points(specimen, specimen.family, cosets, n, random);
  if (random.one_in(3))
    for (Vector& x : specimen.points) x = draw_element(cosets, 3, random) * x;
  if (domain.other_coordinates) {
    if (random.one_in(4)) specimen.generators = other_generators(specimen.generators, random);
    if (specimen.family == "skew-basis" || random.one_in(2))
      specimen.coordinates.linear = draw_basis(d, random);
    if (random.one_in(3)) specimen.coordinates.translation = draw_origin(d, random);
  }
  specimen.naming = static_cast<Naming>(random.below(3));
  if (random.one_in(3)) specimen.alias = random.of(specimen.entry->aliases);
  specimen.choice = random.below(1000);
  return specimen;
}

}  // namespace flatdt::testing
