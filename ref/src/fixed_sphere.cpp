#include "fixed_sphere.hpp"

namespace flatdt::ref {
namespace {

WideInteger<1> one_limb(std::int64_t x) {
  return WideInteger<1>{{static_cast<std::uint64_t>(x)}};
}

/// a[i] b[j] - a[j] b[i].
template <class Row>
Int128 minor(const Row& a, const Row& b, std::size_t i, std::size_t j) {
  return static_cast<Int128>(a[i]) * b[j] - static_cast<Int128>(a[j]) * b[i];
}

}  // namespace

template <int D>
std::optional<FixedSphere<D>> FixedSphere<D>::make(const FixedPredicates<D>& predicates,
                                                   const std::array<OrbitPoint, D + 1>& cell) {
  const auto b = predicates.edges(cell);
  if (!b) return std::nullopt;
  std::array<WideInteger<3>, D> q;
  for (std::size_t k = 0; k < D; ++k) q[k] = predicates.metric().squared_length((*b)[k]);
  FixedSphere sphere(predicates, cell[0]);
  if constexpr (D == 2) {
    const auto without = [&](std::size_t kept) {
      WideInteger<4> determinant = multiply(one_limb((*b)[0][kept]), q[1]);
      determinant -= multiply(one_limb((*b)[1][kept]), q[0]);
      return extended<5>(determinant);
    };
    sphere.c_ = {-without(1), without(0)};
    sphere.beta_ = widened<3>(minor((*b)[0], (*b)[1], 0, 1));
  } else {
    const auto without = [&](std::size_t i, std::size_t j) {
      WideInteger<5> determinant;
      for (std::size_t k = 0; k < 3; ++k)
        determinant += multiply(widened<2>(minor((*b)[(k + 1) % 3], (*b)[(k + 2) % 3], i, j)), q[k]);
      return determinant;
    };
    sphere.c_ = {without(1, 2), -without(0, 2), without(0, 1)};
    for (std::size_t k = 0; k < 3; ++k)
      sphere.beta_ +=
          multiply(widened<2>(minor((*b)[(k + 1) % 3], (*b)[(k + 2) % 3], 0, 1)), one_limb((*b)[k][2]));
  }
  return sphere;
}

template <int D>
std::optional<WideInteger<6>> FixedSphere<D>::power(const OrbitPoint& w) const {
  const auto x = predicates_->difference(w, origin_);
  if (!x) return std::nullopt;
  WideInteger<6> value = -multiply(beta_, predicates_->metric().squared_length(*x));
  for (std::size_t i = 0; i < D; ++i) value += multiply(c_[i], one_limb((*x)[i]));
  return value;
}

template class FixedSphere<2>;
template class FixedSphere<3>;

}  // namespace flatdt::ref
