// The distinct points of the manifold: instance points up to G, by canonical representatives.
#pragma once

#include <optional>
#include <vector>

#include "elements.hpp"
#include "fixed.hpp"
#include "flatdt/checker/ids.hpp"
#include "flatdt/checker/input.hpp"

namespace flatdt::checker {

/// numerator / denominator in lattice coordinates of G.
struct LatticePoint {
  Vec<Integer> numerator;
  Integer denominator;
};

/// The canonical representatives are in `fixed` if they fit, else in `canonical`.
struct Orbits {
  std::vector<OrbitId> of_point;        ///< by PointId
  std::vector<ElementId> frame;         ///< by PointId: point = frame * canonical representative of its orbit
  std::vector<PointId> first_point;     ///< by OrbitId: the least index
  std::optional<FixedPoints> fixed;     ///< by OrbitId
  std::vector<LatticePoint> canonical;  ///< by OrbitId

  [[nodiscard]] std::size_t count() const { return first_point.size(); }
};

/// Sorts the instance's points into G-orbits.
/// Law:   the canonical representative of Gp is the lexicographic minimum of s_r p mod 1 over the linear
/// parts r. G acts
///        freely, so the images are different and the element reaching the minimum is unique.
/// Cost:  O(n log n) comparisons, and |point group| images for each point.
/// `fixed_width`: whether machine integers may be used where all numbers fit; the orbits are the same.
[[nodiscard]] Orbits make_orbits(const Instance& instance, ElementTable& table, bool fixed_width = true);

}  // namespace flatdt::checker
