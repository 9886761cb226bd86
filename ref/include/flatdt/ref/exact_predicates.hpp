/// Exact stage of the predicates: GMP integers over one common denominator, with temporaries kept between
/// calls. Never rationals: measured on the 3D insphere, kept integer temporaries are some 20 times faster.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "flatdt/ref/sites.hpp"

namespace flatdt::ref {

/// A point of GP: an element applied to a site.
struct OrbitPoint {
  SiteId site;
  Element g;
  friend bool operator==(const OrbitPoint&, const OrbitPoint&) = default;
  friend auto operator<=>(const OrbitPoint&, const OrbitPoint&) = default;  // NOLINT(modernize-use-nullptr)
};

/// The Gram matrix scaled to integers.
template <int D>
struct IntegralMetric {
  explicit IntegralMetric(const Frame& frame);
  mpz_class denominator;
  std::array<std::array<mpz_class, D>, D> gram;
  std::array<std::array<mpz_class, D>, D> adjoint;  // of the scaled matrix
  mpz_class determinant;
};

template <int D>
class ExactPredicates {
 public:
  ExactPredicates(const Frame& frame, const GroupTable& table, const std::vector<Site>& sites)
      : ExactPredicates(std::make_shared<const IntegralMetric<D>>(frame), table, sites) {}
  ExactPredicates(std::shared_ptr<const IntegralMetric<D>> metric, const GroupTable& table,
                  const std::vector<Site>& sites)
      : table_(&table), sites_(&sites), metric_(std::move(metric)) {}

  /// Sign of det(p_1 - p_0, ..., p_D - p_0).
  [[nodiscard]] Sign orientation(const std::array<OrbitPoint, D + 1>& p);
  /// Sign of (-1)^D times the determinant of the rows (p_k - w, |p_k - w|^2).
  [[nodiscard]] Sign insphere(const std::array<OrbitPoint, D + 1>& p, const OrbitPoint& w);
  /// Squared circumradius of a cell as numerator / denominator (not reduced), in Gram units.
  /// Formula: with rows a_k = p_k - p_0 and q_k = |a_k|^2, y = adj(A) q solves A y = det(A) q; the centre c
  /// has
  ///   2 A G c = q, so R^2 = y^T adj(G) y / (4 det(A)^2 det(G)).
  /// Requires: the cell is not flat (an InternalError otherwise).
  [[nodiscard]] std::pair<Integer, Integer> squared_circumradius(const std::array<OrbitPoint, D + 1>& p);

 private:
  using Row = std::array<mpz_class, D>;
  void load(const OrbitPoint& p, Row& coordinates, mpz_class& denominator);
  /// rows_[k] = common * (p_k - w), for one common denominator.
  void load_differences(const OrbitPoint* p, std::size_t count, const OrbitPoint& w);
  void determinant3(const Row& a, const Row& b, const Row& c, mpz_class& result);
  void squared_length(const Row& a, mpz_class& result);

  const GroupTable* table_;
  const std::vector<Site>* sites_;
  std::shared_ptr<const IntegralMetric<D>> metric_;

  Row small_;
  std::array<Row, D + 2> points_;
  std::array<mpz_class, D + 2> denominators_;
  std::array<Row, D + 1> rows_;
  std::array<mpz_class, D + 1> lengths_;
  std::array<mpz_class, 6> minors_;
  mpz_class common_, t0_, t1_, det_;
};

extern template struct IntegralMetric<2>;
extern template struct IntegralMetric<3>;
extern template class ExactPredicates<2>;
extern template class ExactPredicates<3>;

}  // namespace flatdt::ref
