/// The star of a point q in the (perturbed) Delaunay triangulation of q and other points of GP, as lifts in
/// E^d, to which points are added one by one (docs/theory.md, section 7).
#pragma once

#include <vector>

#include "flatdt/ref/quotient_complex.hpp"
#include "star_filter.hpp"

namespace flatdt::ref {

template <int D>
class LiftedStar {
 public:
  struct Cell {
    std::array<Lift, D + 1> lifts;  // positively oriented; q is one of them
    typename StarFilter<D>::Sphere sphere;
    bool certified = false;  // for the use of the caller; false in new cells
  };

  LiftedStar(const Lift& q, Predicates<D>& predicates)
      : q_(q), predicates_(&predicates), filter_(predicates.filter(), q.x, predicates.uses_filter()) {
    // Stars of few points on a canonical lattice have up to 30 cells in space.
    constexpr std::size_t kUsual = D == 2 ? 16 : 64;
    cells_.reserve(kUsual);
    gone_.reserve(kUsual / 2);
    facets_.reserve(kUsual * D / 2);
  }

  [[nodiscard]] const Lift& centre() const { return q_; }
  [[nodiscard]] std::vector<Cell>& cells() { return cells_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }

  /// Adds a cell with vertices in any order. Errors: InternalError if it is flat.
  void add(const std::array<Lift, D + 1>& lifts);
  /// The star after `p` has been inserted into the triangulation: the cells in conflict go, and the facets
  /// through q that lie in exactly one of them are joined to p. Requires: p is not a vertex. Whether the star
  /// has changed.
  bool insert(const Lift& p);

  [[nodiscard]] std::vector<CellPoints<D>> points() const;

 private:
  /// A facet through q of the cells that go.
  struct Facet {
    std::uint64_t hash;  // of its other points
    std::uint32_t cell;
    std::uint32_t opposite;
  };
  [[nodiscard]] bool same_points(const Facet& a, const Facet& b) const;
  void collect_facets();

  Lift q_;
  Predicates<D>* predicates_;
  StarFilter<D> filter_;
  std::vector<Cell> cells_;
  // Kept between insertions.
  std::vector<Cell> gone_;
  std::vector<Facet> facets_;
};

extern template class LiftedStar<2>;
extern template class LiftedStar<3>;

}  // namespace flatdt::ref
