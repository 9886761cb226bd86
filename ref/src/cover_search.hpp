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

/// Columns (a,p,q), (0,b,r), (0,0,c) of a Hermite normal form: 0 <= p < b, 0 <= q, r < c. In 2D coordinates
/// are shifted: a = 1, p = q = 0. Comparison is that of the normal forms, column by column.
struct HermiteTriangle {
  long a = 1, p = 0, q = 0, b = 1, r = 0, c = 1;
  friend auto operator<=>(const HermiteTriangle&, const HermiteTriangle&) = default;
};

/// A coset of a plane lattice <(b,r),(0,c)>, or the forbidden part of a layer of Z^3.
struct PlanePoint {
  long y = 0, z = 0;
};

/// layers[h] lists the forbidden (y,z) at height h > 0; those at -h are their negatives.
using Layers = std::vector<std::vector<PlanePoint>>;

/// Tells which w make <(step,w)> + T avoid all layers, T = <(b,r),(0,c)> in height 0.
/// Complexity: preparing costs a step per forbidden vector at a multiple of the step, a question at most one
/// per such layer and mostly a few; b*c words.
class CosetSieve {
 public:
  void prepare(long b, long r, long c, long step, const Layers& layers);
  /// No multiple k w, k > 0, is congruent modulo T to a forbidden vector at height k * step.
  [[nodiscard]] bool is_free(PlanePoint w) const;
  /// Elementary steps of all preparations so far.
  [[nodiscard]] long work() const { return work_; }

 private:
  [[nodiscard]] PlanePoint reduced(PlanePoint x) const;
  [[nodiscard]] bool layer_holds(long k, PlanePoint x) const;

  long b_ = 1, r_ = 0, c_ = 1, step_ = 1, multiples_ = 0, work_ = 0;
  const Layers* layers_ = nullptr;
  /// Bit k mod 64 of a coset: some forbidden vector at height k * step lies in it.
  std::vector<std::uint64_t> marks_;
};

class SublatticeSearch {
 public:
  /// Requires: forbidden is symmetric, without 0, integral; its coordinates are at most kMaxCoordinate, as
  /// they are for bounded sets in a reduced frame.
  SublatticeSearch(const Frame& frame, const std::vector<Vector>& forbidden);

  /// The least Hermite normal form of this index, or nothing. Sums up work().
  /// Complexity: at most O(d(n) s) for n = index in 2D, s the number of forbidden vectors, and O(n^2 + n s)
  /// up to divisor sums in 3D.
  std::optional<Sublattice> least_of_index(long index);
  [[nodiscard]] long work() const { return work_ + line_sieve_.work() + plane_sieve_.work(); }
  static constexpr long kMaxCoordinate = 1L << 20;

 private:
  using Linear = std::array<std::array<long, 3>, 3>;
  using Column = std::array<long, 3>;

  void search_plane(const HermiteTriangle& plane);
  [[nodiscard]] bool is_invariant(const HermiteTriangle& s) const;
  [[nodiscard]] bool may_be_invariant(const HermiteTriangle& plane) const;

  int dimension_;
  std::vector<Linear> holonomy_;
  Layers space_layers_, plane_layers_;  // forbidden (h,y,z), and forbidden (0,h,z) as (0,z)
  std::vector<long> axis_;              // forbidden (0,0,z), z > 0
  CosetSieve line_sieve_, plane_sieve_;
  std::optional<HermiteTriangle> best_;
  long work_ = 0;
};

}  // namespace flatdt::ref
