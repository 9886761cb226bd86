/// Orientation and perturbed insphere of points of GP: the floating-point filter, then integers of fixed
/// width, then of any size, then the symbolic perturbation. Law: the result is the exact one whatever stage
/// speaks; `PredicateStages` can leave stages out (tests do).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flatdt/ref/exact_predicates.hpp"
#include "flatdt/ref/filter.hpp"
#include "flatdt/ref/fixed_predicates.hpp"
#include "flatdt/ref/tie_order.hpp"

namespace flatdt::ref {

/// A point of GP with its approximate coordinates in the frame.
struct Lift {
  std::array<double, 3> x{};
  OrbitPoint point;
};

/// The stages before the last one, which is GMP's integers.
enum class PredicateStages : std::uint8_t { filtered, filter_only, fixed_only, exact_only };

/// What depends on the metric and the group alone, made once for many point sets.
template <int D>
struct PredicateConstants {
  PredicateConstants(const Frame& frame, const GroupTable& table)
      : filter(frame, table.row_sum()),
        fixed(frame),
        integral(std::make_shared<const IntegralMetric<D>>(frame)) {}
  Filter<D> filter;
  FixedMetric<D> fixed;
  std::shared_ptr<const IntegralMetric<D>> integral;
};

template <int D>
class Predicates {
 public:
  Predicates(const Frame& frame, const GroupTable& table, const std::vector<Site>& sites,
             const TieOrder& order, PredicateStages stages)
      : Predicates(PredicateConstants<D>(frame, table), table, sites, order, stages) {}
  Predicates(const PredicateConstants<D>& constants, const GroupTable& table, const std::vector<Site>& sites,
             const TieOrder& order, PredicateStages stages)
      : filter_(constants.filter),
        fixed_(constants.fixed, table, sites),
        exact_(constants.integral, table, sites),
        order_(&order),
        use_filter_(stages == PredicateStages::filtered || stages == PredicateStages::filter_only),
        use_fixed_(stages == PredicateStages::filtered || stages == PredicateStages::fixed_only) {}

  using Simplex = std::array<Lift, D + 1>;

  /// Sign of det(p_1 - p_0, ..., p_D - p_0): zero iff the points lie on a hyperplane.
  [[nodiscard]] Sign orientation(const Simplex& p) {
    if (use_filter_)
      if (const auto sign = filter_.orientation(coordinates(p))) return *sign;
    if (use_fixed_)
      if (const auto sign = fixed_.orientation(points(p))) return *sign;
    return exact_.orientation(points(p));
  }

  /// Is w in conflict with the cell: strictly inside its circumsphere, or on it and inside after the
  /// perturbation? Requires: the cell is positively oriented and w is none of its vertices. Never undecided.
  /// Source: [DevillersTeillaud03], with the order of TieOrder (INSERTION 2).
  [[nodiscard]] bool conflict_sos(const Simplex& cell, const Lift& w) {
    const Sign sign = insphere(cell, w);
    return sign != Sign::zero ? sign == Sign::positive : perturbed_conflict(cell, w);
  }

  /// insphere() and orientation() by the filter alone, if it may speak and is certain.
  [[nodiscard]] std::optional<Sign> quick_insphere(const std::array<std::array<double, 3>, D + 1>& cell,
                                                   const std::array<double, 3>& w) const {
    return use_filter_ ? filter_.insphere(cell, w) : std::nullopt;
  }
  [[nodiscard]] std::optional<Sign> quick_orientation(
      const std::array<std::array<double, 3>, D + 1>& p) const {
    return use_filter_ ? filter_.orientation(p) : std::nullopt;
  }

  /// Sign of insphere(cell; w): positive iff w is strictly inside. Requires: the cell is positively oriented.
  [[nodiscard]] Sign insphere(const Simplex& cell, const Lift& w) {
    if (use_filter_)
      if (const auto sign = filter_.insphere(coordinates(cell), w.x)) return *sign;
    if (use_fixed_)
      if (const auto sign = fixed_.insphere(points(cell), w.point)) return *sign;
    return exact_.insphere(points(cell), w.point);
  }

  /// How often the perturbation has asked for the largest of points of which two that might be it are in one
  /// orbit, so that the ranks of the orbits alone did not answer.
  [[nodiscard]] std::size_t ties_within_orbits() const { return ties_within_orbits_; }

  [[nodiscard]] const Filter<D>& filter() const { return filter_; }
  [[nodiscard]] bool uses_filter() const { return use_filter_; }
  [[nodiscard]] bool uses_fixed() const { return use_fixed_; }
  [[nodiscard]] const FixedPredicates<D>& fixed() const { return fixed_; }
  [[nodiscard]] ExactPredicates<D>& exact() { return exact_; }

 private:
  static std::array<std::array<double, 3>, D + 1> coordinates(const Simplex& p) {
    std::array<std::array<double, 3>, D + 1> x;
    for (std::size_t k = 0; k <= D; ++k) x[k] = p[k].x;
    return x;
  }
  static std::array<OrbitPoint, D + 1> points(const Simplex& p) {
    std::array<OrbitPoint, D + 1> x;
    for (std::size_t k = 0; k <= D; ++k) x[k] = p[k].point;
    return x;
  }
  [[nodiscard]] bool perturbed_conflict(const Simplex& cell, const Lift& w);

  Filter<D> filter_;
  FixedPredicates<D> fixed_;
  ExactPredicates<D> exact_;
  const TieOrder* order_;
  bool use_filter_;
  bool use_fixed_;
  std::size_t ties_within_orbits_ = 0;
};

extern template class Predicates<2>;
extern template class Predicates<3>;

}  // namespace flatdt::ref
