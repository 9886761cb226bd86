/// The Delaunay triangulation of points in the terms of the engine: sites, and cells as lists of points of
/// GP.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "flatdt/ref/periodic_delaunay.hpp"
#include "flatdt/ref/prepared_group.hpp"
#include "flatdt/ref/skeleton_cycles.hpp"

namespace flatdt::ref {

enum class CoverChoice : std::uint8_t { smallest, theorem10 };

/// In which order orbits are inserted, and how they are located.
enum class InsertionOrder : std::uint8_t {
  batch,  // along a space-filling curve, each from the one before it (insertion_order.hpp)
  random  // by the Delaunay hierarchy (Section 4.2): what a user who inserts points one by one gets
};

struct TriangulationOptions {
  Insertion insertion = Insertion::without_covers;
  /// The covering engine inserts in random order, as Section 4.3 has it, whatever stands here.
  InsertionOrder order = InsertionOrder::batch;
  /// The cover that copies are inserted in, by the covering engine.
  CoverChoice cover = CoverChoice::smallest;
  /// Seed of the insertion order and of the hierarchy's levels. The triangulation does not depend on it.
  std::uint64_t order_seed = 0;
  long max_sheets = 20000;
  PredicateStages stages = PredicateStages::filtered;
  /// Where the manifold carries no triangulation: the smallest cover that carries one of these points,
  /// instead of the smallest that carries one of any points.
  bool smallest_cover = false;
  /// See Setting::region_limit.
  std::size_t region_limit = kRegionLimit;
};

template <int D>
struct FrameTriangulation {
  /// The distinct points of the manifold.
  std::vector<Site> sites;
  /// One lift of each cell modulo G or, where the manifold carries no triangulation, modulo the group that
  /// the tie order is invariant under (G; for the didicosm of index 2); unfold() makes of those the cells of
  /// `cover`. As canonical lists, sorted.
  CellList<D> cells;
  /// The cover that is written, if the manifold carries none; then also the reason: a short cycle or, for the
  /// didicosm only, a cell that some element does not map to a cell.
  std::optional<Sublattice> cover;
  std::optional<ShortCycle> cycle;
  struct Variance {
    CellPoints<D> cell;
    Element element;
  };
  std::optional<Variance> variance;
  /// The cover that was worked in; nothing without covers.
  std::optional<Sublattice> working_cover;
  /// After how many orbits the list L was empty and the algorithm went on in the manifold, if ever.
  std::optional<std::size_t> switched_after;
  std::size_t hierarchy_levels = 0;
  /// What the largest empty ball is found from (empty_diameter_squared()).
  WidestCells<D> widest;
};

/// The squared diameter of the largest empty ball, exact, in Gram units. Only on demand: of two points in the
/// plane it would take a fifth of the time. Requires: an answer of triangulate_in_frame() for this group.
template <int D>
[[nodiscard]] Rational empty_diameter_squared(const FrameTriangulation<D>& answer,
                                              const PreparedGroup& group);

/// Triangulates points given in instance coordinates by the algorithm of Section 4, or without covers.
/// Errors: LimitReached if the cover to work in needs more than max_sheets sheets. Requires: at least one
/// point; the group has dimension D. Complexity: expected O(n log n) predicates on evenly spread points,
/// times the sheets until the switch with Insertion::covering. The cells are a function of the points and the
/// group alone. Memory, for n evenly spread points in space whose numbers fit (sites.hpp), without covers and
/// with no cycles to be looked for, besides the points: 332 n bytes and O(n^(2/3)): sites 48, vertices 32 and
/// their index 4, the order 4, and 6.77 cells [Meijering53] of 36; at the end sites and cells of 32.
template <int D>
FrameTriangulation<D> triangulate_in_frame(const std::vector<Vector>& points, const PreparedGroup& group,
                                           const TriangulationOptions& options);

/// The same; the points are let go of as soon as their sites are made.
template <int D>
FrameTriangulation<D> triangulate_in_frame(std::vector<Vector>&& points, const PreparedGroup& group,
                                           const TriangulationOptions& options);

extern template Rational empty_diameter_squared<2>(const FrameTriangulation<2>&, const PreparedGroup&);
extern template Rational empty_diameter_squared<3>(const FrameTriangulation<3>&, const PreparedGroup&);
extern template FrameTriangulation<2> triangulate_in_frame<2>(std::vector<Vector>&&, const PreparedGroup&,
                                                              const TriangulationOptions&);
extern template FrameTriangulation<3> triangulate_in_frame<3>(std::vector<Vector>&&, const PreparedGroup&,
                                                              const TriangulationOptions&);
extern template FrameTriangulation<2> triangulate_in_frame<2>(const std::vector<Vector>&,
                                                              const PreparedGroup&,
                                                              const TriangulationOptions&);
extern template FrameTriangulation<3> triangulate_in_frame<3>(const std::vector<Vector>&,
                                                              const PreparedGroup&,
                                                              const TriangulationOptions&);

}  // namespace flatdt::ref
