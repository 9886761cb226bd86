/// Circumradii of cells: comparison with the threshold of Corollary 9, and the diameter of the largest empty
/// ball.
#pragma once

#include <memory>
#include <vector>

#include "flatdt/ref/quotient_complex.hpp"

namespace flatdt::ref {

/// Enclosure [lo, hi] of a real number in doubles; every operation rounds outwards.
struct Interval {
  double lo = 0;
  double hi = 0;
};

/// Cells of which one has the largest circumscribed ball, its squared radius enclosed (Gram units).
template <int D>
struct WidestCells {
  std::vector<CellPoints<D>> cells;
  Interval squared_radius;
};

/// The squared diameter of the largest circumscribed ball of the cells, exact, in Gram units; of the widest
/// cells of a triangulation this is Delta^2, the squared diameter of the largest empty ball.
/// Requires: at least one cell, none flat.
template <int D>
[[nodiscard]] Rational squared_diameter(const std::vector<CellPoints<D>>& cells, ExactPredicates<D>& exact);

/// What depends on the metric and the group alone.
template <int D>
struct CircumradiusConstants {
  explicit CircumradiusConstants(const Frame& frame);
  Rational threshold;  // delta^2 / 16
  Interval threshold_interval;
  std::array<std::array<Interval, D>, D> gram;
  std::array<std::array<double, D>, D> approximate_gram{};
  std::array<std::array<double, D>, D> approximate_adjoint{};
  double approximate_determinant = 0;
  double gram_sum = 0;     // of the absolute values of the entries
  double adjoint_sum = 0;  // of the adjoint's
  double row_sum = 1;      // the largest of a linear part
};

template <int D>
class Circumradius {
 public:
  Circumradius(const Frame& frame, Predicates<D>& predicates)
      : Circumradius(std::make_shared<const CircumradiusConstants<D>>(frame), predicates) {}
  Circumradius(std::shared_ptr<const CircumradiusConstants<D>> constants, Predicates<D>& predicates)
      : predicates_(&predicates), c_(std::move(constants)) {}

  /// Is 16 R^2 >= delta^2, R the circumradius of the cell? Such cells make up the list L of Section 4.1.
  /// Corollary 9 asks for diameter 2R < delta/2; the "threshold delta" of Section 4.1 is a slip (DESIGN).
  [[nodiscard]] bool is_large(const std::array<Lift, D + 1>& cell);

  /// Requires: at least one cell. Nothing is kept of cells that cannot have the largest ball by what is known
  /// when they are met: on evenly spread points, O(log n) are kept.
  [[nodiscard]] WidestCells<D> widest(const QuotientComplex<D>& complex) const;
  /// Is one of the cells large?
  [[nodiscard]] bool has_large(const WidestCells<D>& widest);

 private:
  using Coordinates = std::array<std::array<double, 3>, D + 1>;  // of the vertices of a lift

  /// Enclosure of R^2 in Gram units, quickly found; infinite where the doubles cannot tell.
  /// Error analysis: at its definition.
  [[nodiscard]] Interval bounds(const Coordinates& cell) const;
  /// Enclosure of R^2 in Gram units; the whole real line when the doubles cannot tell. May stop at a lower
  /// bound that is at least `enough`.
  [[nodiscard]] Interval enclose(const Coordinates& cell, double enough) const;

  Predicates<D>* predicates_;
  std::shared_ptr<const CircumradiusConstants<D>> c_;
};

extern template Rational squared_diameter<2>(const std::vector<CellPoints<2>>&, ExactPredicates<2>&);
extern template Rational squared_diameter<3>(const std::vector<CellPoints<3>>&, ExactPredicates<3>&);
extern template struct CircumradiusConstants<2>;
extern template struct CircumradiusConstants<3>;
extern template class Circumradius<2>;
extern template class Circumradius<3>;

}  // namespace flatdt::ref
