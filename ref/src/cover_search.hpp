/// The sublattice of Z^d of least index that is invariant under a finite group and avoids a finite set of
/// vectors.
/// Invariants: no floating point and no metric: what a caller wants avoided is listed exactly.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flatdt/ref/cover.hpp"

namespace flatdt::ref {

/// Columns (a,p,q), (0,b,r), (0,0,c) of a Hermite normal form in reversed coordinates (the last coordinate of
/// the frame first): 0 <= p < b, 0 <= q, r < c. In 2D they lie in the plane of height 0 of Z^3: a = 1, p = q
/// = 0.
struct HermiteTriangle {
  long a = 1, p = 0, q = 0, b = 1, r = 0, c = 1;
};

/// A coset of a plane lattice <(b,r),(0,c)>, or the forbidden part of a layer of Z^3.
struct PlanePoint {
  long y = 0, z = 0;
  friend auto operator<=>(const PlanePoint&, const PlanePoint&) = default;
};

/// layers[h] lists the forbidden (y,z) at height h > 0, sorted; those at -h are their negatives.
using Layers = std::vector<std::vector<PlanePoint>>;

/// Tells which w make <(step,w)> + T avoid all layers, T = <(b,r),(0,c)> in height 0.
/// Complexity: preparing costs a step per forbidden vector at a multiple of the step, a question at most one
/// per such layer and mostly a few; b*c words.
class CosetSieve {
 public:
  void prepare(long b, long r, long c, long step, const Layers& layers);
  /// No multiple k w, k > 0, is congruent modulo T to a forbidden vector at height k * step.
  bool is_free(PlanePoint w);
  /// Elementary steps so far.
  [[nodiscard]] long work() const { return work_; }

 private:
  [[nodiscard]] PlanePoint reduced(PlanePoint x) const;
  [[nodiscard]] bool layer_holds(long k, PlanePoint x) const;

  long b_ = 1, r_ = 0, c_ = 1, step_ = 1, multiples_ = 0, work_ = 0;
  const Layers* layers_ = nullptr;
  /// Bit k mod 64 of a coset: some forbidden vector at height k * step lies in it.
  std::vector<std::uint64_t> marks_;
};

/// Searches sublattices by their plane part in height 0, then by the cosets of that plane lattice.
/// Order of coordinates: the height is the last coordinate of the frame, along its longest vector, because
/// then the plane lattices are pruned most (4 to 10 times fewer steps than with the first, torus at 1:1:10);
/// but the middle one if the holonomy acts on the plane as +-1, so that it prunes no plane lattice (30 times,
/// dicosm). Complexity of an index n, s the number of forbidden vectors: O(n + s) steps in 2D and O(n^2 + n
/// s) in 3D, times divisor sums.
class SublatticeSearch {
 public:
  /// Requires: forbidden is symmetric, without 0, integral; its coordinates are at most kMaxCoordinate, as
  /// they are for bounded sets in a reduced frame.
  SublatticeSearch(const Frame& frame, const std::vector<Vector>& forbidden, long max_work);

  /// The sublattice of this index with the least Hermite normal form, column by column; nothing if there is
  /// none or the search is exhausted().
  std::optional<Sublattice> least_of_index(long index);
  /// More than max_work elementary steps were done, over all calls.
  [[nodiscard]] bool exhausted() const {
    return work_ + line_sieve_.work() + plane_sieve_.work() > max_work_;
  }
  static constexpr long kMaxCoordinate = 1L << 20;

 private:
  using Linear = std::array<std::array<long, 3>, 3>;
  using Column = std::array<long, 3>;

  void choose_order(const Frame& frame);
  [[nodiscard]] std::size_t slot(int frame_coordinate) const {
    return slot_[static_cast<std::size_t>(frame_coordinate)];
  }
  void search_planes(HermiteTriangle s);
  void search_plane(HermiteTriangle s);
  void record(const HermiteTriangle& s);
  [[nodiscard]] bool is_invariant(const HermiteTriangle& s) const;
  [[nodiscard]] bool may_be_invariant(const HermiteTriangle& plane) const;

  int dimension_;
  /// Place of each frame coordinate in a Column; the plane of 2D has height 0.
  std::array<std::size_t, 3> slot_ = {2, 1, 0};
  std::vector<Linear> holonomy_;
  Layers space_layers_, plane_layers_;  // forbidden (h,y,z), and forbidden (0,h,z) as (0,z)
  std::vector<long> axis_;              // forbidden (0,0,z), z > 0
  CosetSieve line_sieve_, plane_sieve_;
  /// Transpose of the best basis in frame coordinates: the order of matrices is then that of normal forms.
  std::optional<Matrix> best_;
  long work_ = 0, max_work_;
};

}  // namespace flatdt::ref
