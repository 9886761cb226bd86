/// Whole sets at once on the square and the cubic torus, against the peer on the same doubles.
#include "ours.hpp"
#include "peer.hpp"

namespace flatdt::bench {
namespace {

std::vector<Part> side_by_side(const PointSet& set) {
  const auto n = static_cast<double>(set.points.size());
  std::vector<Part> parts{{"flatdt", n, our_triangulation(torus_instance(set))}};
  if (peer_version().empty()) return parts;
  parts.push_back({"cgal", n, peer_batch(set)});
  if (set.dimension == 2) parts.push_back({"cgal-hierarchy", n, peer_hierarchy(set)});
  return parts;
}

Experiment batch(const std::string& set, int dimension) {
  return {"batch-" + std::to_string(dimension) + "d-" + set,
          set + " points of the " + (dimension == 2 ? "square" : "cubic") + " torus, all at once",
          [set, dimension](const Settings& settings) {
            return side_by_side(point_set(set, dimension, settings.points));
          }};
}

/// Work on n points and on ten times as many.
std::vector<Part> growth_parts(const Settings& settings) {
  std::vector<Part> parts;
  for (const std::size_t factor : {std::size_t{1}, std::size_t{10}}) {
    for (Part& part : side_by_side(point_set("uniform", 3, factor * settings.points))) {
      if (factor == 10) part.name += "-tenfold";
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

std::vector<Part> single_part(const Settings& settings) {
  const auto n = static_cast<double>(settings.points);
  ref::Instance instance = settings.family == "uniform"
                               ? uniform_instance(settings.manifold, settings.points)
                               : family_instance(settings.manifold, settings.family, settings.points);
  return {{settings.manifold + "/" + settings.family, n, our_triangulation(std::move(instance))}};
}

}  // namespace

std::vector<Experiment> batch_experiments() {
  return {batch("uniform", 3),
          batch("rounded-grid", 3),
          batch("integer-grid", 3),
          batch("uniform", 2),
          {"growth", "uniform points of the cubic torus, and ten times as many", growth_parts},
          {"single", "one of the reference's families on one manifold (--manifold, --family)", single_part}};
}

}  // namespace flatdt::bench
