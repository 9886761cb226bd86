/// The circumscribed sphere of one cell, to compare many points with: what of the insphere determinant
/// depends on the cell alone is computed once.
///
/// With b_k = p_k - p_0, q_k = |b_k|^2 and x = w - p_0: from the rows (p_k - w, |p_k - w|^2) take the first,
/// then add the others' columns 2 G x times to the last; this leaves (-x, -|x|^2) and (b_k, q_k), without a
/// change of the determinant. Expanded along the first: the insphere determinant, times (-1)^d, is
///   sum_i c_i x_i - beta |x|^2,  beta = det(b), c_i = (-1)^(d+1+i) det(b, q without coordinate i).
/// Bounds, with the letters of fixed_predicates.hpp, b and g at most 62: c_i is below 2^(4b+g+7) <= 2^317 in
/// space and 2^(3b+g+5) in the plane (5 limbs), beta below 2^(3b+3) <= 2^189 (3 limbs), the sum below
/// 2^(5b+g+10) <= 2^382 (6 limbs).
#pragma once

#include <optional>

#include "flatdt/ref/fixed_predicates.hpp"

namespace flatdt::ref {

template <int D>
class FixedSphere {
 public:
  /// Nothing if the numbers do not fit. Requires: the cell is positively oriented. Keeps a reference.
  static std::optional<FixedSphere> make(const FixedPredicates<D>& predicates,
                                         const std::array<OrbitPoint, D + 1>& cell);

  /// The insphere determinant of the cell and w, its sign that of FixedPredicates::insphere; of several w it
  /// is the greater, the nearer w is to the centre. Nothing if the numbers do not fit.
  [[nodiscard]] std::optional<WideInteger<6>> power(const OrbitPoint& w) const;

 private:
  FixedSphere(const FixedPredicates<D>& predicates, const OrbitPoint& origin)
      : predicates_(&predicates), origin_(origin) {}

  const FixedPredicates<D>* predicates_;
  OrbitPoint origin_;
  std::array<WideInteger<5>, D> c_;
  WideInteger<3> beta_;
};

extern template class FixedSphere<2>;
extern template class FixedSphere<3>;

}  // namespace flatdt::ref
