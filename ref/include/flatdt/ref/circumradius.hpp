/// Circumradii of cells: comparison with the threshold of Corollary 9, and the diameter of the largest empty
/// ball.
#pragma once

#include <vector>

#include "flatdt/ref/quotient_complex.hpp"

namespace flatdt::ref {

/// Enclosure [lo, hi] of a real number in doubles; every operation rounds outwards.
struct Interval {
  double lo = 0;
  double hi = 0;
};

template <int D>
class Circumradius {
 public:
  Circumradius(const Frame& frame, Predicates<D>& predicates);

  /// Is 16 R^2 >= delta^2, R the circumradius of the cell? Such cells make up the list L of Section 4.1.
  /// Corollary 9 asks for diameter 2R < delta/2; the "threshold delta" of Section 4.1 is a slip (DESIGN).
  [[nodiscard]] bool is_large(const std::array<Lift, D + 1>& cell);

  /// Delta^2 = 4 max R^2 over the cells (exact, Gram units): the squared diameter of the largest empty ball.
  /// Requires: at least one cell.
  [[nodiscard]] Rational squared_diameter(const std::vector<std::array<Lift, D + 1>>& cells);

 private:
  /// Enclosure of R^2 in Gram units; the whole real line when the doubles cannot tell. May stop at a lower
  /// bound that is at least `enough`.
  [[nodiscard]] Interval enclose(const std::array<Lift, D + 1>& cell, double enough) const;

  Predicates<D>* predicates_;
  Rational threshold_;  // delta^2 / 16
  Interval threshold_interval_;
  std::array<std::array<Interval, D>, D> gram_;
  double row_sum_;
};

extern template class Circumradius<2>;
extern template class Circumradius<3>;

}  // namespace flatdt::ref
