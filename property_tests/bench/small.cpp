/// Whole triangulations of few points on the tori: how many a second.
#include "ours.hpp"
#include "peer.hpp"

namespace flatdt::bench {
namespace {

/// Different sets, because a few points are no average.
constexpr std::uint64_t kSets = 32;

std::vector<Part> small_parts(int dimension, std::size_t n) {
  std::vector<PointSet> sets;
  std::vector<ref::Instance> instances;
  for (std::uint64_t seed = 1; seed <= kSets; ++seed) {
    sets.push_back(point_set("uniform", dimension, n, seed));
    instances.push_back(torus_instance(sets.back()));
  }
  std::vector<Part> parts{{"flatdt", kSets, our_triangulations(instances)},
                          {"flatdt-with-analysis", kSets, our_triangulations(instances, true)}};
  if (peer_version().empty()) return parts;
  std::vector<Work> each;
  for (const PointSet& set : sets) each.push_back(peer_one_by_one(set));
  parts.push_back({"cgal", kSets, [each] {
                     Done last;
                     for (const Work& work : each) last = work();
                     return last;
                   }});
  return parts;
}

}  // namespace

std::vector<Experiment> small_experiments() {
  std::vector<Experiment> all;
  for (const int dimension : {3, 2})
    for (const std::size_t n : {1U, 2U, 4U, 8U, 16U})
      all.push_back({"small-" + std::to_string(dimension) + "d-" + std::to_string(n),
                     "triangulations of " + std::to_string(n) + " uniform points of the " +
                         (dimension == 2 ? "square" : "cubic") + " torus",
                     [dimension, n](const Settings&) { return small_parts(dimension, n); }, true});
  return all;
}

}  // namespace flatdt::bench
