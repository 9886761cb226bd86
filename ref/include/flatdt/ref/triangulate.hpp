/// The Delaunay triangulation of an instance: of the manifold where it exists for this tie-break, else of a
/// cover.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "flatdt/ref/frame_triangulation.hpp"
#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::ref {

/// Why the answer is a triangulation of a cover, in the instance's points and coordinates.
struct StayedInCover {
  enum class Kind : std::uint8_t { loop, two_cycle, not_invariant };
  Kind kind = Kind::loop;
  /// loop: the edge from points[first] to g * points[first].
  /// two_cycle: the edges from points[first] to g * points[second] and to h * points[second].
  /// not_invariant (didicosm): a cell, as text, that g does not map to a cell.
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  Isometry g{Matrix(0), Vector(0)};
  Isometry h{Matrix(0), Vector(0)};
  std::string cell;
};

struct TriangulationResult {
  Triangulation triangulation;
  std::size_t distinct_points = 0;
  /// Sheets of the cover that is written; 1 for the manifold.
  long sheets = 1;
  /// Sheets and index in the translation lattice of the cover that was worked in; nothing without covers.
  std::optional<Sublattice> working_cover;
  /// After how many orbits the list L was empty and the algorithm went on in the manifold, if ever.
  std::optional<std::size_t> switched_after;
  std::size_t hierarchy_levels = 0;
  Rational delta_squared;
  /// The squared diameter of the largest empty ball.
  Rational empty_diameter_squared;
  std::optional<StayedInCover> reason;  // set iff a cover is written
};

/// Triangulates the instance by the algorithm of Section 4.
/// Errors: InvalidInput for an inadmissible group; LimitReached if the cover needs more than max_sheets
/// sheets. Complexity: expected O(h n log n) predicates on well-distributed points, h the sheets until the
/// switch. The triangulation is a function of the instance alone.
TriangulationResult triangulate(const Instance& instance, const GroupAnalysis& analysis,
                                const TriangulationOptions& options);

/// The same with a group that is used for many instances. Requires: `group` is that of the instance.
TriangulationResult triangulate(const Instance& instance, const PreparedGroup& group,
                                const TriangulationOptions& options);

/// The same; the instance's points are let go of on the way.
TriangulationResult triangulate(Instance&& instance, const PreparedGroup& group,
                                const TriangulationOptions& options);

/// The comments that the written file carries: a function of the instance alone.
std::vector<std::string> describe(const TriangulationResult& result);

}  // namespace flatdt::ref
