#include "flatdt/ref/families.hpp"

#include <algorithm>

#include "families_internal.hpp"
#include "flatdt/ref/errors.hpp"

namespace flatdt::ref {
namespace {

using namespace families_detail;

struct Rule {
  Family family;
  Points (*points)(const Setting&, long, Random&);
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> kRules = {
      {{"uniform", "independent points of the unit cell, multiples of 2^-20"}, uniform},
      {{"lattice",
        "the first n orbits met by the multiples of a random lattice vector: a lattice on a torus"},
       lattice},
      {{"grid", "n orbits of the coarsest grid (1/m)Z^d that has so many, in random order"}, grid},
      {{"on-axis",
        "on screw axes; else on lines that a glide reflection translates; on a torus on the coordinate axes"},
       on_axis},
      {{"on-glide-plane",
        "on planes (lines) of glide reflections; without them on planes x_k = 0 and x_k = 1/2 for one k"},
       on_glide_plane},
      {{"cospherical", "exactly on one sphere (circle) that is empty and smaller than delta/2"}, cospherical},
      {{"near-cospherical", "off such a sphere by factors 1 +- 2^-k, k from 8 to 60"}, near_cospherical},
      {{"clustered", "in about sqrt(n) clusters of widths 2^-4 to 2^-12"}, clustered},
      {{"single-orbit", "n representatives of one orbit: one point of the manifold"}, single_orbit},
      {{"nearly-duplicate", "pairs at coordinate distance 2^-20 to 2^-60, one of each moved by the group"},
       nearly_duplicate},
      {{"far-from-cell", "uniform, each moved by a group element with translations of up to 2^50"},
       far_from_cell},
      {{"long-cell", "uniform, in a cell stretched to an axis ratio of 10 to 1000"}, uniform},
      {{"skew-basis", "uniform, group, metric and points written in a random unimodular basis"}, uniform},
      {{"moment-curve", "on a small piece of the moment curve (t, t^2, t^3), in 2D of a parabola"},
       moment_curve},
  };
  return kRules;
}

const Rule& rule_of(std::string_view family) {
  const auto& all = rules();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Rule& r) { return r.family.name == family; });
  if (found != all.end()) return *found;
  std::string names;
  for (const Rule& r : all) names += (names.empty() ? "" : ", ") + r.family.name;
  throw InvalidInput("no family is called \"" + std::string(family.substr(0, 40)) + "\"; there are " + names);
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> kFamilies = [] {
    std::vector<Family> list;
    for (const Rule& r : rules()) list.push_back(r.family);
    return list;
  }();
  return kFamilies;
}

Instance generate(const CatalogueEntry& entry, std::string_view name, std::string_view family, long n,
                  std::uint64_t seed, std::string_view metric) {
  const Rule& rule = rule_of(family);
  if (n < 1 || n > kMaxGeneratedPoints)
    throw InvalidInput("the number of points must be 1 to " + std::to_string(kMaxGeneratedPoints) + ", not " +
                       std::to_string(n));
  if (metric != "canonical" && metric != "random")
    throw InvalidInput("the metric must be canonical or random, not \"" + std::string(metric.substr(0, 40)) +
                       "\"");

  Instance instance;
  instance.dimension = entry.dimension;
  instance.name = std::string(name);
  instance.generators = generators_of(entry, name);
  instance.gram = entry.canonical_gram;
  const Setting setting(instance);
  // Separate streams: the points of a family that does not look at the metric do not depend on it.
  Random metric_random(seed, entry.name + "/metric");
  if (metric == "random") instance.gram = random_gram(instance.gram, setting.cosets, metric_random);
  if (family == "long-cell") instance.gram = stretched_gram(instance.gram, setting.cosets, metric_random);
  ensure(is_positive_definite(instance.gram), "generated metrics are positive definite");
  for (const Isometry& g : setting.cosets)
    ensure(preserves_metric(g.linear, instance.gram), "generated metrics are invariant");

  Random random(seed, entry.name + "/" + std::string(family));
  instance.points = rule.points(setting, n, random);
  return family == "skew-basis" ? in_skew_basis(instance, random) : instance;
}

}  // namespace flatdt::ref
