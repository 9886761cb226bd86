/// Few points in long cells, axis lengths 1 : 10^6, on all twelve manifolds.
#include <set>

#include "flatdt/ref/catalogue.hpp"
#include "ours.hpp"
#include "point_sets.hpp"

namespace flatdt::bench {
namespace {

constexpr long kLong = 1000000;
constexpr std::array<std::array<long, 3>, 6> kStretches{
    {{1, 1, kLong}, {1, kLong, 1}, {kLong, 1, 1}, {kLong, kLong, 1}, {kLong, 1, kLong}, {1, kLong, kLong}}};

/// The lengths of the first `dimension` axes, like "1:1e6"; "" if they are all the same.
std::string axis_ratio(const std::array<long, 3>& stretch, int dimension) {
  std::string text;
  bool differ = false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    if (k > 0) text += ":";
    text += stretch[k] == 1 ? "1" : "1e6";
    differ = differ || stretch[k] != stretch[0];
  }
  return differ ? text : "";
}

std::vector<Part> long_cell_parts(const Settings&) {
  std::vector<Part> parts;
  for (const ref::CatalogueEntry& entry : ref::catalogue()) {
    std::set<std::string> seen;  // in the plane several stretches are the same
    for (const std::array<long, 3>& stretch : kStretches) {
      const std::string ratio = axis_ratio(stretch, entry.dimension);
      if (ratio.empty() || !admits_stretch(entry.name, stretch) || !seen.insert(ratio).second) continue;
      for (const std::size_t n : {1U, 2U, 3U, 5U, 10U, 20U})
        parts.push_back({entry.name + "/" + ratio + "/" + std::to_string(n), 1,
                         our_triangulation(stretched_instance(entry.name, stretch, n))});
    }
  }
  return parts;
}

}  // namespace

std::vector<Experiment> long_cell_experiments() {
  return {{"long-cells", "1 to 20 uniform points in cells with axis lengths 1 : 10^6", long_cell_parts}};
}

}  // namespace flatdt::bench
