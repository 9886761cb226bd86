/// Floating-point stage of the predicates: the sign of a determinant in doubles, or nothing when the error
/// bound does not exclude the other signs. Certain or silent.
///
/// Error analysis (u = 2^-53, round to nearest, no fused multiply-add).
/// Input. A lift is g d, g = {R|tau+t}, with d in [0,1]^d known to 4u per coordinate (sites.hpp), rho = the
///   largest absolute row sum of a linear part, 0 <= tau < 1. The input and the 3 products err by at most
///   5 rho u, the partial sums by (rho + rho + (rho + 1) + |x|) u, tau by u; the translation of a base
///   position of a coset representative (t = 0), by |x| u more. So the error of a coordinate is below (8 rho
///   + 2 + 2 |x|) u, and below e = 2^-48 (rho + 1 + |x|_max) with a factor of 4 to spare.
/// Differences a = fl(x - w): |a - exact| <= 2e + u|a| <= eta = 2.25 e, since |a| <= 2 |x|_max.
/// With A_i the largest |a_i| over the rows, A'_i = A_i + eta bounds the exact and the computed entries. A
///   product of d entries then moves by at most the sum over i of eta prod_{j != i} A'_j (telescoping).
/// Lifted entry q = a^T G a: bounded by Q = sum |G_ij| A'_i A'_j; rounding of at most 9 terms of 2 products
///   each and of the entries of G: at most 24 u Q; input: 2 eta sum |G_ij| A'_j. Together kappa.
/// Determinant: d! products, each with fewer than 12 roundings in the evaluation below.
/// The bounds are evaluated in doubles themselves; the factors 3, 7 and 25 instead of 2, 6 and 24 cover that.
/// Underflow: G is scaled by a power of 2 so that its largest entry is in (1/2,2); if its smallest nonzero
/// entry
///   is below about 2^-400 insphere() stays silent. All other terms of a bound contain eta >= 2^-48, so that
///   a bound is above 2^-300 and what underflows is far below its spare. Overflow: |x| < 2^16.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::ref {

template <int D>
class Filter {
 public:
  Filter(const Frame& frame, int row_sum);

  using Point = std::array<double, 3>;

  /// Sign of det(p_1 - p_0, ..., p_D - p_0), if certain.
  [[nodiscard]] std::optional<Sign> orientation(const std::array<Point, D + 1>& p) const;
  /// Sign of (-1)^D times the determinant of the rows (p_k - w, |p_k - w|^2), if certain: positive iff w is
  /// strictly inside the circumsphere of a positively oriented p.
  [[nodiscard]] std::optional<Sign> insphere(const std::array<Point, D + 1>& p, const Point& w) const;

  /// Whether insphere() ever speaks.
  [[nodiscard]] bool enabled() const { return enabled_; }
  /// Error bounds of the two determinants when the differences of the points from one of them, at `origin`,
  /// are computed as at most `largest` along each axis.
  struct Bounds {
    double orientation;
    double insphere;
  };
  [[nodiscard]] Bounds bounds(const Point& origin, std::array<double, D> largest) const;
  /// x^T G x, G scaled; the error analysis above is of this order of evaluation.
  [[nodiscard]] double squared_length(const std::array<double, D>& x) const {
    double sum = 0;
    for (std::size_t i = 0; i < D; ++i) {
      double row = 0;
      for (std::size_t j = 0; j < D; ++j) row += gram_[i][j] * x[j];
      sum += row * x[i];
    }
    return sum;
  }

  /// Squared length of p - q in scaled Gram units: an approximation for heuristics only.
  [[nodiscard]] double approximate_squared_distance(const Point& p, const Point& q) const;

 private:
  [[nodiscard]] double eta(const Point& origin, const std::array<double, D>& largest) const;

  bool enabled_ = true;
  double row_sum_;
  std::array<std::array<double, 3>, 3> gram_{};
};

template <int D>
double Filter<D>::eta(const Point& origin, const std::array<double, D>& largest) const {
  double x = 0;
  for (std::size_t i = 0; i < D; ++i) x = std::max(x, std::fabs(origin[i]) + largest[i]);
  return 2.25 * 0x1p-48 * (row_sum_ + 1 + x);
}

template <int D>
typename Filter<D>::Bounds Filter<D>::bounds(const Point& origin, std::array<double, D> largest) const {
  const double h = eta(origin, largest);
  for (double& value : largest) value += h;
  double q_bound = 0;
  double q_slope = 0;
  for (std::size_t i = 0; i < D; ++i) {
    double row = 0;
    double plain = 0;
    for (std::size_t j = 0; j < D; ++j) {
      row += std::fabs(gram_[i][j]) * largest[j];
      plain += std::fabs(gram_[i][j]);
    }
    q_bound += row * largest[i];
    q_slope += plain * largest[i];
  }
  const double kappa = 24 * 0x1p-53 * q_bound + 2.1 * h * q_slope;
  const double xy = largest[0] * largest[1];
  if constexpr (D == 2) {
    return {3 * (12 * 0x1p-53 * xy + h * (largest[0] + largest[1])),
            7 * (12 * 0x1p-53 * xy * q_bound + h * (largest[0] + largest[1]) * q_bound + kappa * xy)};
  } else {
    const double xz = largest[0] * largest[2], yz = largest[1] * largest[2], xyz = xy * largest[2];
    return {7 * (12 * 0x1p-53 * xyz + h * (xy + xz + yz)),
            25 * (12 * 0x1p-53 * xyz * q_bound + h * (xy + xz + yz) * q_bound + kappa * xyz)};
  }
}

template <int D>
std::optional<Sign> Filter<D>::orientation(const std::array<Point, D + 1>& p) const {
  std::array<std::array<double, D>, D> a;
  std::array<double, D> largest{};
  for (std::size_t k = 0; k < D; ++k)
    for (std::size_t i = 0; i < D; ++i) {
      a[k][i] = p[k + 1][i] - p[0][i];
      largest[i] = std::max(largest[i], std::fabs(a[k][i]));
    }
  const double h = eta(p[0], largest);
  for (double& value : largest) value += h;
  double det = 0;
  double bound = 0;
  if constexpr (D == 2) {
    det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    bound = 3 * (12 * 0x1p-53 * largest[0] * largest[1] + h * (largest[0] + largest[1]));
  } else {
    det = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
          a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
          a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    const double xy = largest[0] * largest[1], xz = largest[0] * largest[2], yz = largest[1] * largest[2];
    bound = 7 * (12 * 0x1p-53 * xy * largest[2] + h * (xy + xz + yz));
  }
  if (det > bound) return Sign::positive;
  if (det < -bound) return Sign::negative;
  return std::nullopt;
}

template <int D>
std::optional<Sign> Filter<D>::insphere(const std::array<Point, D + 1>& p, const Point& w) const {
  if (!enabled_) return std::nullopt;
  std::array<std::array<double, D>, D + 1> a;
  std::array<double, D + 1> q;
  std::array<double, D> largest{};
  for (std::size_t k = 0; k <= D; ++k) {
    for (std::size_t i = 0; i < D; ++i) {
      a[k][i] = p[k][i] - w[i];
      largest[i] = std::max(largest[i], std::fabs(a[k][i]));
    }
    double sum = 0;
    for (std::size_t i = 0; i < D; ++i) {
      double row = 0;
      for (std::size_t j = 0; j < D; ++j) row += gram_[i][j] * a[k][j];
      sum += row * a[k][i];
    }
    q[k] = sum;
  }
  const double h = eta(w, largest);
  for (double& value : largest) value += h;
  double q_bound = 0;
  double q_slope = 0;
  for (std::size_t i = 0; i < D; ++i) {
    double row = 0;
    double plain = 0;
    for (std::size_t j = 0; j < D; ++j) {
      row += std::fabs(gram_[i][j]) * largest[j];
      plain += std::fabs(gram_[i][j]);
    }
    q_bound += row * largest[i];
    q_slope += plain * largest[i];
  }
  const double kappa = 24 * 0x1p-53 * q_bound + 2.1 * h * q_slope;
  double det = 0;
  double bound = 0;
  if constexpr (D == 2) {
    const double m01 = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    const double m02 = a[0][0] * a[2][1] - a[0][1] * a[2][0];
    const double m12 = a[1][0] * a[2][1] - a[1][1] * a[2][0];
    det = m12 * q[0] - m02 * q[1] + m01 * q[2];
    const double xy = largest[0] * largest[1];
    bound = 7 * (12 * 0x1p-53 * xy * q_bound + h * (largest[0] + largest[1]) * q_bound + kappa * xy);
  } else {
    // Expansion along the columns (x,y) x (z,q) by 2 x 2 minors of the first two columns.
    const auto minor = [&a](std::size_t r, std::size_t s) { return a[r][0] * a[s][1] - a[r][1] * a[s][0]; };
    const auto cominor = [&a, &q](std::size_t r, std::size_t s) { return a[r][2] * q[s] - a[s][2] * q[r]; };
    det = minor(0, 1) * cominor(2, 3) - minor(0, 2) * cominor(1, 3) + minor(0, 3) * cominor(1, 2) +
          minor(1, 2) * cominor(0, 3) - minor(1, 3) * cominor(0, 2) + minor(2, 3) * cominor(0, 1);
    det = -det;
    const double xy = largest[0] * largest[1], xz = largest[0] * largest[2], yz = largest[1] * largest[2];
    const double xyz = xy * largest[2];
    bound = 25 * (12 * 0x1p-53 * xyz * q_bound + h * (xy + xz + yz) * q_bound + kappa * xyz);
  }
  if (det > bound) return Sign::positive;
  if (det < -bound) return Sign::negative;
  return std::nullopt;
}

template <int D>
double Filter<D>::approximate_squared_distance(const Point& p, const Point& q) const {
  double sum = 0;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) sum += gram_[i][j] * (p[i] - q[i]) * (p[j] - q[j]);
  return sum;
}

extern template class Filter<2>;
extern template class Filter<3>;

}  // namespace flatdt::ref
