// The distinct points of the manifold: instance points up to G, by canonical representatives.
#pragma once

#include <vector>

#include "elements.hpp"
#include "flatdt/checker/ids.hpp"
#include "flatdt/checker/input.hpp"

namespace flatdt::checker {

/// numerator / denominator in lattice coordinates of G.
struct LatticePoint {
  Vec<Integer> numerator;
  Integer denominator;
};

struct Orbits {
  std::vector<OrbitId> of_point;        ///< by PointId
  std::vector<ElementId> frame;         ///< by PointId: point = frame * canonical[of_point]
  std::vector<PointId> first_point;     ///< by OrbitId: the least index
  std::vector<LatticePoint> canonical;  ///< by OrbitId

  [[nodiscard]] std::size_t count() const { return canonical.size(); }
};

/// Sorts the instance's points into G-orbits.
/// Law:   the canonical representative of Gp is the lexicographic minimum of s_r p mod 1 over the linear
/// parts r. G acts
///        freely, so the images are different and the element reaching the minimum is unique.
/// Cost:  O(n log n) comparisons, and |point group| images for each point.
[[nodiscard]] Orbits make_orbits(const Instance& instance, ElementTable& table);

}  // namespace flatdt::checker
