/// The circumscribed sphere of one cell in doubles: for heuristics only. Formulas: fixed_sphere.hpp.
#pragma once

#include "flatdt/ref/filter.hpp"

namespace flatdt::ref {

template <int D>
class ApproximateSphere {
 public:
  using Point = typename Filter<D>::Point;

  /// The coefficients c and beta of power(), from the edges b_k and their squared lengths q_k.
  ApproximateSphere(const Filter<D>& filter, const std::array<Point, D + 1>& cell)
      : filter_(&filter), origin_(cell[0]) {
    std::array<std::array<double, D>, D> b;
    std::array<double, D> q;
    for (std::size_t k = 0; k < D; ++k) {
      for (std::size_t i = 0; i < D; ++i) b[k][i] = cell[k + 1][i] - origin_[i];
      q[k] = filter.squared_length(b[k]);
    }
    if constexpr (D == 2) {
      c_ = {b[1][1] * q[0] - b[0][1] * q[1], b[0][0] * q[1] - b[1][0] * q[0]};
      beta_ = b[0][0] * b[1][1] - b[0][1] * b[1][0];
    } else {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto &u = b[(k + 1) % 3], &v = b[(k + 2) % 3];
        const std::array<double, 3> product{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                            u[0] * v[1] - u[1] * v[0]};
        for (std::size_t i = 0; i < 3; ++i) c_[i] += q[k] * product[i];
        beta_ += b[k][2] * product[2];
      }
    }
  }

  /// Whether the power has a maximum, as that of a positively oriented cell does.
  [[nodiscard]] bool has_centre() const { return beta_ > 0; }
  /// c = 2 beta G x there. Not finite, or far off, for a flat cell.
  [[nodiscard]] Point centre() const {
    Point centre = origin_;
    const auto offset = filter_->raised(c_);
    for (std::size_t i = 0; i < D; ++i) centre[i] += offset[i] / (2 * beta_);
    return centre;
  }
  /// c.x - beta |x|^2 with x = w - p_0: the greater, the nearer w is to the centre.
  [[nodiscard]] double power(const Point& w) const {
    std::array<double, D> x;
    double value = 0;
    for (std::size_t i = 0; i < D; ++i) {
      x[i] = w[i] - origin_[i];
      value += c_[i] * x[i];
    }
    return value - beta_ * filter_->squared_length(x);
  }

 private:
  const Filter<D>* filter_;
  Point origin_;
  std::array<double, D> c_{};
  double beta_ = 0;
};

}  // namespace flatdt::ref
