/// The ten 3-manifolds side by side, as many orbits on each.
#include "flatdt/ref/catalogue.hpp"
#include "ours.hpp"
#include "point_sets.hpp"

namespace flatdt::bench {
namespace {

std::vector<Part> manifold_parts(const Settings& settings) {
  std::vector<Part> parts;
  for (const ref::CatalogueEntry& entry : ref::catalogue())
    if (entry.dimension == 3)
      parts.push_back({entry.name, static_cast<double>(settings.points),
                       our_triangulation(uniform_instance(entry.name, settings.points))});
  return parts;
}

}  // namespace

std::vector<Experiment> manifold_experiments() {
  return {{"manifolds", "uniform orbits on each of the ten 3-manifolds", manifold_parts}};
}

}  // namespace flatdt::bench
