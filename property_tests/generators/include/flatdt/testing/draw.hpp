/// Random specimens: every manifold, admissible metrics, rational changes of basis and origin, other
/// generators, and the point sets of all named families, of small rational grids and of orbit midpoints.
/// Laws: valid by construction, so nothing is ever discarded; a function of the arguments alone, on every
/// machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "flatdt/testing/specimen.hpp"

namespace flatdt::testing {

/// Names that ref::find_entry knows: the twelve manifolds, then the mirror images P32, P43, P65.
std::vector<std::string> manifolds_of_the_plane();
std::vector<std::string> manifolds_of_space();
std::vector<std::string> all_manifolds();

/// Rules for points beside the families of ref: points k/m with m <= 6 (repetitions allowed), and a point
/// with the midpoints between it and its images.
inline constexpr const char* kSmallGridRule = "small-grid";
inline constexpr const char* kMidpointRule = "orbit-midpoints";
/// All rules: those of ref::families() and the two above.
std::vector<std::string> point_rules();

/// What may be drawn. Bounds on the number of points and on the metric's axis ratio are bounds on cost: the
/// reference inserts some 9 * ratio copies of each point in the plane, 35 * ratio^2 and more in space.
struct Domain {
  std::vector<std::string> manifolds;
  long min_points = 1;
  long max_points_in_plane = 10;
  long max_points_in_space = 3;
  /// Largest ratio by which a class of axes is stretched against the others.
  long max_stretch_in_plane = 20;
  long max_stretch_in_space = 1;
  bool other_metrics = true;
  /// Other bases, origins and generators.
  bool other_coordinates = true;
  /// Empty: all of point_rules().
  std::vector<std::string> rules;

  [[nodiscard]] long max_points(int dimension) const {
    return dimension == 2 ? max_points_in_plane : max_points_in_space;
  }
};

/// The specimen with number `seed`; the number of points grows with size, 0 to 100.
/// Requires: domain.manifolds is not empty.
Specimen draw_specimen(const Domain& domain, std::uint64_t seed, int size);

}  // namespace flatdt::testing
