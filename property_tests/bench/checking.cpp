/// Checking in memory: our checker on our triangulation, CGAL's is_valid() on CGAL's, of the same points.
#include "ours.hpp"
#include "peer.hpp"

namespace flatdt::bench {
namespace {

Experiment checking(const std::string& set, int dimension) {
  return {"checking-" + std::to_string(dimension) + "d-" + set,
          "validity of the triangulation of " + set + " points of the " +
              (dimension == 2 ? "square" : "cubic") + " torus",
          [set, dimension](const Settings& settings) {
            const PointSet points = point_set(set, dimension, settings.points);
            const auto n = static_cast<double>(points.points.size());
            std::vector<Part> parts{{"flatdt", n, our_check(torus_instance(points))}};
            if (!peer_version().empty()) parts.push_back({"cgal", n, peer_validity(points)});
            return parts;
          }};
}

}  // namespace

std::vector<Experiment> checking_experiments() {
  return {checking("uniform", 3), checking("rounded-grid", 3), checking("uniform", 2)};
}

}  // namespace flatdt::bench
