/// The floating-point filter for many tests about one point q: insphere and orientation of cells of the star
/// of q, of which what depends on the cell alone is computed once. Certain or silent.
///
/// Relative to q, with x = p - q and l = |x|^2, the insphere determinant of the cell q, p_1, .., p_d and w
/// is, up to its sign, the determinant of the rows (x_1, l_1), .., (x_d, l_d), (x_w, l_w), and the
/// orientation that of the rows x_1, .., x_d: the determinants of filter.hpp with q for the origin. Expanded
/// along the last row, each of the (d+1)!, or d!, products goes through fewer than 12 roundings, as there. So
/// the error bounds of filter.hpp hold, with the largest entries over all points that have been seen: one
/// bound for all cells.
#pragma once

#include <optional>

#include "flatdt/ref/filter.hpp"

namespace flatdt::ref {

template <int D>
class StarFilter {
 public:
  using Point = typename Filter<D>::Point;
  /// A point seen from q.
  struct Offset {
    std::array<double, D> x;
    double length;
  };
  /// Of q and D points: c.x - beta l is the insphere determinant.
  struct Sphere {
    std::array<double, D> c;
    double beta;
  };
  /// Through q and D - 1 points: normal.x is the determinant with the D-th point last.
  struct Plane {
    std::array<double, D> normal;
  };

  /// `speaks`: else it is silent about everything.
  StarFilter(const Filter<D>& filter, const Point& q, bool speaks)
      : filter_(&filter), q_(q), speaks_(speaks), speaks_of_spheres_(speaks && filter.enabled()) {}

  [[nodiscard]] const Point& centre() const { return q_; }
  /// Widens the bounds, so that they hold for this point too.
  Offset see(const Point& p);
  /// Of q, p_1, .., p_D in this order, if the cell is positively oriented; of the negative of its determinant
  /// if told that it is negatively oriented.
  [[nodiscard]] Sphere sphere(const std::array<Offset, D>& p, bool is_negative) const;
  [[nodiscard]] Plane plane(const std::array<Offset, D - 1>& p) const;

  /// Positive: w is strictly inside.
  [[nodiscard]] std::optional<Sign> insphere(const Sphere& sphere, const Offset& w) const {
    if (!speaks_of_spheres_) return std::nullopt;
    double det = -sphere.beta * w.length;
    for (std::size_t i = 0; i < D; ++i) det += sphere.c[i] * w.x[i];
    return beyond(det, sphere_bound_);
  }
  /// Sign of the orientation of q, the points of the plane, w.
  [[nodiscard]] std::optional<Sign> orientation(const Plane& plane, const Offset& w) const {
    if (!speaks_) return std::nullopt;
    double det = 0;
    for (std::size_t i = 0; i < D; ++i) det += plane.normal[i] * w.x[i];
    return beyond(det, plane_bound_);
  }

 private:
  static std::optional<Sign> beyond(double det, double bound) {
    if (det > bound) return Sign::positive;
    if (det < -bound) return Sign::negative;
    return std::nullopt;
  }

  const Filter<D>* filter_;
  Point q_;
  bool speaks_;
  bool speaks_of_spheres_;
  std::array<double, D> largest_{};
  double sphere_bound_ = 0;
  double plane_bound_ = 0;
};

extern template class StarFilter<2>;
extern template class StarFilter<3>;

}  // namespace flatdt::ref
