#include "flatdt/ref/group_table.hpp"

#include <algorithm>
#include <cstdlib>

namespace flatdt::ref {
namespace {

int small_integer(const Rational& value) {
  ensure(value.is_integer() && value.numerator().fits_long() && std::labs(value.numerator().to_long()) < 1000,
         "linear parts and carries of a reduced frame are small integers");
  return static_cast<int>(value.numerator().to_long());
}

}  // namespace

GroupTable::GroupTable(const Frame& frame)
    : dimension_(frame.dimension), denominator_(frame.translation_denominator), cosets_(frame.cosets) {
  const int d = dimension_;
  const std::size_t n = cosets_.size();
  ensure(n >= 1 && cosets_[0].is_identity(), "the first coset representative is the identity");
  for (const Isometry& g : cosets_) {
    Linear linear{};
    std::array<double, 3> tau{};
    std::array<int, 3> scaled{};
    for (int i = 0; i < d; ++i) {
      int sum = 0;
      for (int j = 0; j < d; ++j) {
        const int entry = small_integer(g.linear(i, j));
        linear[static_cast<std::size_t>(3 * i + j)] = entry;
        sum += std::abs(entry);
      }
      row_sum_ = std::max(row_sum_, sum);
      const auto k = static_cast<std::size_t>(i);
      scaled[k] = small_integer(Rational(denominator_) * g.translation[i]);
      ensure(scaled[k] >= 0 && scaled[k] < denominator_, "coset translations lie in [0,1)");
      tau[k] = static_cast<double>(scaled[k]) / denominator_;
    }
    linear_.push_back(linear);
    tau_.push_back(tau);
    scaled_tau_.push_back(scaled);
    reverses_.push_back(g.linear.determinant().sign() == Sign::negative);
  }
  product_.resize(n * n);
  inverse_.resize(n);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      const Isometry g = cosets_[a] * cosets_[b];
      std::size_t c = 0;
      while (c < n && !(cosets_[c].linear == g.linear)) ++c;
      ensure(c < n, "the linear parts are closed under multiplication");
      Product& p = product_[a * n + b];
      p.coset = static_cast<std::uint16_t>(c);
      for (int i = 0; i < d; ++i)
        p.carry[static_cast<std::size_t>(i)] = small_integer(g.translation[i] - cosets_[c].translation[i]);
      if (c == 0) {
        // (a,0)(b,0) = (0,carry), so (a,0)^-1 = (b,0)(0,-carry) = (b, -R_b carry).
        const Vector carry = g.translation;
        const Vector moved = cosets_[b].linear * carry;
        inverse_[a].coset = static_cast<std::uint16_t>(b);
        for (int i = 0; i < d; ++i) inverse_[a].carry[static_cast<std::size_t>(i)] = -small_integer(moved[i]);
      }
    }
  }
}

void GroupTable::throw_too_long() {
  throw LimitReached("a group element moves by more than 32767 lattice vectors: the lattice is too long");
}

Isometry GroupTable::isometry(const Element& g) const {
  Isometry map = cosets_[g.coset];
  for (int i = 0; i < dimension_; ++i)
    map.translation[i] += Rational(static_cast<long>(g.t[static_cast<std::size_t>(i)]));
  return map;
}

Element GroupTable::element(const Isometry& g) const {
  for (std::size_t c = 0; c < cosets_.size(); ++c) {
    if (!(cosets_[c].linear == g.linear)) continue;
    std::array<int, 3> t{};
    for (int i = 0; i < dimension_; ++i) {
      const Rational difference = g.translation[i] - cosets_[c].translation[i];
      ensure(difference.is_integer(), "the map is an element of the group");
      const Integer value = difference.numerator();
      if (value.bits() > 30) throw LimitReached("a group element moves by more than 32767 lattice vectors");
      t[static_cast<std::size_t>(i)] = static_cast<int>(value.to_long());
    }
    return checked(t[0], t[1], t[2], static_cast<std::uint16_t>(c));
  }
  throw InternalError("the map is an element of the group");
}

std::array<std::int64_t, 3> GroupTable::left_order_key(const Element& g) const {
  // With {R|t}^-1 = {R^-1 | -R^-1 t}, the key R^-1 t is minus the translation of the inverse.
  const Element inverse_element = inverse(g);
  std::array<std::int64_t, 3> key{};
  for (std::size_t i = 0; i < 3; ++i)
    key[i] = -(static_cast<std::int64_t>(denominator_) * inverse_element.t[i] +
               scaled_tau_[inverse_element.coset][i]);
  return key;
}

}  // namespace flatdt::ref
