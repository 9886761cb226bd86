#include "subgroups.hpp"

#include <algorithm>
#include <deque>
#include <optional>

#include "flatdt/ref/lattice.hpp"
#include "metrics.hpp"
#include "random.hpp"
#include "require.hpp"

namespace flatdt::property_tests {
namespace {

using ref::Isometry;
using ref::Matrix;
using ref::Rational;
using ref::Vector;

/// A subgroup H as cosets of its lattice: g is in H iff its linear part occurs and the translations differ by
/// a vector of the lattice.
struct Subgroup {
  std::vector<Isometry> elements;  // one for each linear part
  ref::HermiteBasis lattice;

  [[nodiscard]] bool contains(const Isometry& g) const {
    return std::any_of(elements.begin(), elements.end(), [&](const Isometry& h) {
      return h.linear == g.linear && lattice.contains(g.translation - h.translation);
    });
  }
};

/// Schreier: products of generators, one for each linear part; translations that the other products give.
Subgroup generated(const std::vector<Isometry>& generators) {
  const int d = generators.front().dimension();
  Subgroup h{{Isometry::identity(d)}, ref::HermiteBasis(d)};
  for (std::size_t i = 0; i < h.elements.size(); ++i)
    for (const Isometry& g : generators) {
      const Isometry product = h.elements[i] * g;
      const bool known = std::any_of(h.elements.begin(), h.elements.end(),
                                     [&](const Isometry& e) { return e.linear == product.linear; });
      if (!known) h.elements.push_back(product);
    }
  for (const Isometry& e : h.elements)
    for (const Isometry& g : generators) {
      const Isometry product = e * g;
      for (const Isometry& f : h.elements)
        if (f.linear == product.linear) h.lattice.add((product * f.inverse()).translation);
    }
  return h;
}

/// Representatives of the right cosets Hr of G, found by multiplying with the generators of G from the right;
/// nothing if there are more than `most`.
std::optional<std::vector<Isometry>> right_cosets(const Subgroup& h, const std::vector<Isometry>& of_group,
                                                  std::size_t most) {
  std::vector<Isometry> representatives{Isometry::identity(of_group.front().dimension())};
  for (std::size_t i = 0; i < representatives.size(); ++i)
    for (const Isometry& g : of_group) {
      const Isometry next = representatives[i] * g;
      const bool known = std::any_of(representatives.begin(), representatives.end(),
                                     [&](const Isometry& r) { return h.contains(next * r.inverse()); });
      if (!known) representatives.push_back(next);
      if (representatives.size() > most) return std::nullopt;
    }
  return representatives;
}

SubgroupInstance instance_for(const testing::Specimen& s, const std::vector<Isometry>& generators,
                              const std::vector<Isometry>& representatives) {
  const Isometry back = s.coordinates.inverse();
  SubgroupInstance result{instance_of(s), representatives.size(), {}};
  for (const Isometry& r : representatives) result.representatives.push_back(back * r * s.coordinates);
  result.instance.name.reset();
  result.instance.generators_given = true;
  result.instance.generators.clear();
  for (const Isometry& g : generators) result.instance.generators.push_back(back * g * s.coordinates);
  result.instance.points.clear();
  for (const Isometry& r : representatives)
    for (const Vector& x : s.points) result.instance.points.push_back(back * (r * x));
  return result;
}

std::vector<Isometry> draw_generators(const testing::Specimen& s, testing::Random& random) {
  const std::vector<Isometry> cosets = testing::cosets_of(catalogue_generators(s));
  std::vector<Isometry> generators;
  // A lattice of small index: columns of a lower triangular matrix.
  for (int j = 0; j < s.dimension(); ++j) {
    Vector column(s.dimension());
    column[j] = random.between(1, 3);
    for (int i = j + 1; i < s.dimension(); ++i) column[i] = random.between(0, 1);
    generators.push_back(Isometry::translate(column));
  }
  for (std::uint64_t extra = random.below(3); extra > 0; --extra) {
    Vector t(s.dimension());
    for (int i = 0; i < s.dimension(); ++i) t[i] = random.between(-1, 1);
    generators.push_back(Isometry::translate(t) * random.of(cosets));
  }
  return generators;
}

}  // namespace

SubgroupInstance subgroup_instance(const testing::Specimen& s, const std::vector<Isometry>& generators) {
  const auto representatives = right_cosets(generated(generators), s.generators, 1000);
  require(representatives.has_value(), "the subgroup has index at most 1000");
  return instance_for(s, generators, *representatives);
}

SubgroupInstance draw_subgroup(const testing::Specimen& s, std::size_t max_index, std::uint64_t seed) {
  testing::Random random(seed);
  // Each draw is an index-2 or index-3 subgroup with positive probability; a thousand failures in a row are
  // practically impossible, and an error.
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::vector<Isometry> generators = draw_generators(s, random);
    const auto representatives = right_cosets(generated(generators), s.generators, max_index);
    if (representatives && representatives->size() > 1) return instance_for(s, generators, *representatives);
  }
  throw Violation("no subgroup of small index was found");
}

}  // namespace flatdt::property_tests
