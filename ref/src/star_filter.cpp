#include "star_filter.hpp"

namespace flatdt::ref {
namespace {

template <class Row>
double minor(const Row& a, const Row& b, std::size_t i, std::size_t j) {
  return a[i] * b[j] - a[j] * b[i];
}

}  // namespace

template <int D>
typename StarFilter<D>::Offset StarFilter<D>::see(const Point& p) {
  Offset offset;
  bool is_wider = false;
  for (std::size_t i = 0; i < D; ++i) {
    offset.x[i] = p[i] - q_[i];
    if (!(std::fabs(offset.x[i]) > largest_[i])) continue;
    largest_[i] = std::fabs(offset.x[i]);
    is_wider = true;
  }
  offset.length = filter_->squared_length(offset.x);
  if (is_wider) {
    const auto bounds = filter_->bounds(q_, largest_);
    sphere_bound_ = bounds.insphere;
    plane_bound_ = bounds.orientation;
  }
  return offset;
}

template <int D>
typename StarFilter<D>::Sphere StarFilter<D>::sphere(const std::array<Offset, D>& p, bool is_negative) const {
  Sphere s{};
  if constexpr (D == 2) {
    // -det of the rows (x_1, l_1), (x_2, l_2), (x_w, l_w).
    s.c = {p[1].x[1] * p[0].length - p[0].x[1] * p[1].length,
           p[0].x[0] * p[1].length - p[1].x[0] * p[0].length};
    s.beta = minor(p[0].x, p[1].x, 0, 1);
  } else {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &u = p[(k + 1) % 3].x, &v = p[(k + 2) % 3].x;
      const double xy = minor(u, v, 0, 1);
      s.c[0] += p[k].length * minor(u, v, 1, 2);
      s.c[1] -= p[k].length * minor(u, v, 0, 2);
      s.c[2] += p[k].length * xy;
      s.beta += p[k].x[2] * xy;
    }
  }
  if (is_negative) {
    for (double& c : s.c) c = -c;
    s.beta = -s.beta;
  }
  return s;
}

template <int D>
typename StarFilter<D>::Plane StarFilter<D>::plane(const std::array<Offset, D - 1>& p) const {
  if constexpr (D == 2)
    return {{-p[0].x[1], p[0].x[0]}};
  else
    return {{minor(p[0].x, p[1].x, 1, 2), -minor(p[0].x, p[1].x, 0, 2), minor(p[0].x, p[1].x, 0, 1)}};
}

template class StarFilter<2>;
template class StarFilter<3>;

}  // namespace flatdt::ref
