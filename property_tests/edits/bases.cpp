#include "bases.hpp"

namespace flatdt::edits {

namespace {

const std::vector<std::string> kManifolds = {
    "torus",           "klein-bottle",     "torocosm",          "dicosm",
    "tricosm",         "tetracosm",        "hexacosm",          "didicosm",
    "first-amphicosm", "second-amphicosm", "first-amphidicosm", "second-amphidicosm"};

}  // namespace

std::vector<Recipe> recipes(bool quick, std::size_t rounds, std::uint64_t seed) {
  std::vector<Recipe> all;
  for (std::size_t round = 0; round < (quick ? 1 : rounds); ++round) {
    for (std::size_t m = 0; m < kManifolds.size(); ++m) {
      const std::string& manifold = kManifolds[m];
      const bool planar = m < 2;
      const std::uint64_t s = seed * 1000 + round * 100 + m;
      const auto add = [&](const std::string& family, long points, const std::string& metric) {
        all.push_back({manifold, family, points, metric, s + all.size()});
      };
      if (planar) {
        // The manifold itself, mostly; then covering spaces.
        for (const char* family : {"uniform", "grid", "near-cospherical", "cospherical", "clustered"})
          add(family, planar ? 24 : 60, "canonical");
        for (const char* family : {"uniform", "lattice", "skew-basis", "single-orbit"})
          add(family, 3, "random");
      } else {
        add("uniform", 60, "canonical");
        add("near-cospherical", 60, "canonical");
        add("grid", manifold == "torocosm" ? 27 : 64, "canonical");
        add("cospherical", 8, "canonical");
        add("uniform", 2, "random");
        add("grid", 1, "canonical");
      }
    }
  }
  return all;
}

}  // namespace flatdt::edits
