/// The star of a point q in the (perturbed) Delaunay triangulation of q and other points of GP, as lifts in
/// E^d, to which points are added one by one (docs/theory.md, section 7).
#pragma once

#include <vector>

#include "flatdt/ref/quotient_complex.hpp"

namespace flatdt::ref {

template <int D>
class LiftedStar {
 public:
  struct Cell {
    std::array<Lift, D + 1> lifts;  // positively oriented; q is one of them
    bool certified = false;         // for the use of the caller; false in new cells
  };

  LiftedStar(const Lift& q, Predicates<D>& predicates) : q_(q), predicates_(&predicates) {}

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
  Lift q_;
  Predicates<D>* predicates_;
  std::vector<Cell> cells_;
};

extern template class LiftedStar<2>;
extern template class LiftedStar<3>;

}  // namespace flatdt::ref
