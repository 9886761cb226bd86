/// Elements of finite order: a crystallographic group without any acts freely.
#include "flatdt/ref/errors.hpp"
#include "group_parts.hpp"

namespace flatdt::ref {

CyclicSum cyclic_sum(const Matrix& linear) {
  constexpr int kMaxOrder = 6;  // the crystallographic restriction
  CyclicSum result{1, Matrix::identity(linear.dimension())};
  for (Matrix power = linear; !power.is_identity(); power = power * linear) {
    ensure(result.order < kMaxOrder, "an element of a point group has order 1, 2, 3, 4 or 6");
    result.sum = result.sum + power;
    ++result.order;
  }
  return result;
}

/// g = {R|t + l} has finite order iff g^m = {I|N(t + l)} is the identity, where m is the order of R and
/// N = I + R + ... + R^(m-1): so iff N l = -N t has a solution l in Z^d. Then g fixes the barycentre of the
/// orbit of 0, (0 + g 0 + ... + g^(m-1) 0) / m.
std::optional<FixedPoint> find_fixed_point(const WorkingGroup& group) {
  for (const Isometry& coset : group.cosets) {
    if (coset.linear.is_identity()) continue;
    const CyclicSum cyclic = cyclic_sum(coset.linear);
    const auto l = solve_integral(cyclic.sum, -(cyclic.sum * coset.translation));
    if (!l) continue;
    const Isometry element{coset.linear, coset.translation + *l};
    const int d = coset.dimension();
    Vector image(d), sum(d);
    for (int k = 0; k < cyclic.order; ++k) {
      sum = sum + image;
      image = element * image;
    }
    ensure(image.is_zero(), "an element of finite order returns 0 to itself");
    const FixedPoint found{element, Rational(Integer(1), Integer(cyclic.order)) * sum};
    ensure(found.element * found.point == found.point, "the barycentre of an orbit is fixed");
    return found;
  }
  return std::nullopt;
}

}  // namespace flatdt::ref
