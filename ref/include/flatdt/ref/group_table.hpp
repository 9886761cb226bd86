/// Group elements as small integers, and the tables that multiply them.
/// Role: everything hot works on Element; Isometry is for input and output.
/// Invariants: an Element {coset c, t} is the map x -> R_c x + tau_c + t in frame coordinates, t integral.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::ref {

/// A group element: a coset of the translation lattice and an integral translation in frame coordinates.
struct Element {
  std::array<std::int16_t, 3> t{};
  std::uint16_t coset = 0;
  friend bool operator==(const Element&, const Element&) = default;
  /// A total order for sorting; it has no geometric meaning.
  friend auto operator<=>(const Element&, const Element&) = default;  // NOLINT(modernize-use-nullptr)
  [[nodiscard]] bool is_identity() const { return *this == Element{}; }
  /// All of it in one number.
  [[nodiscard]] std::uint64_t packed() const {
    const auto bits = [](std::int16_t value) {
      return static_cast<std::uint64_t>(static_cast<std::uint16_t>(value));
    };
    return bits(t[0]) | bits(t[1]) << 16U | bits(t[2]) << 32U | static_cast<std::uint64_t>(coset) << 48U;
  }
};

class GroupTable {
 public:
  /// Requires: a frame from analyse().
  explicit GroupTable(const Frame& frame);

  [[nodiscard]] int dimension() const { return dimension_; }
  [[nodiscard]] int cosets() const { return static_cast<int>(linear_.size()); }
  [[nodiscard]] int translation_denominator() const { return denominator_; }

  /// g h. Throws LimitReached when a translation leaves the range of Element.
  [[nodiscard]] Element multiply(const Element& g, const Element& h) const {
    if (g.coset == 0) {
      return checked(g.t[0] + h.t[0], g.t[1] + h.t[1], g.t[2] + h.t[2], h.coset);
    }
    const Linear& r = linear_[g.coset];
    const Product& p = product_[g.coset * linear_.size() + h.coset];
    return checked(g.t[0] + r[0] * h.t[0] + r[1] * h.t[1] + r[2] * h.t[2] + p.carry[0],
                   g.t[1] + r[3] * h.t[0] + r[4] * h.t[1] + r[5] * h.t[2] + p.carry[1],
                   g.t[2] + r[6] * h.t[0] + r[7] * h.t[1] + r[8] * h.t[2] + p.carry[2], p.coset);
  }
  [[nodiscard]] Element inverse(const Element& g) const {
    if (g.coset == 0) return checked(-g.t[0], -g.t[1], -g.t[2], 0);
    const Product& p = inverse_[g.coset];
    const Linear& r = linear_[p.coset];
    return checked(p.carry[0] - (r[0] * g.t[0] + r[1] * g.t[1] + r[2] * g.t[2]),
                   p.carry[1] - (r[3] * g.t[0] + r[4] * g.t[1] + r[5] * g.t[2]),
                   p.carry[2] - (r[6] * g.t[0] + r[7] * g.t[1] + r[8] * g.t[2]), p.coset);
  }
  [[nodiscard]] bool reverses_orientation(const Element& g) const { return reverses_[g.coset]; }

  /// g x in doubles. Error analysis: see filter.hpp.
  [[nodiscard]] std::array<double, 3> apply(const Element& g, const std::array<double, 3>& x) const {
    if (g.coset == 0) return {x[0] + g.t[0], x[1] + g.t[1], x[2] + g.t[2]};
    const Linear& r = linear_[g.coset];
    const std::array<double, 3>& tau = tau_[g.coset];
    return {r[0] * x[0] + r[1] * x[1] + r[2] * x[2] + tau[0] + g.t[0],
            r[3] * x[0] + r[4] * x[1] + r[5] * x[2] + tau[1] + g.t[1],
            r[6] * x[0] + r[7] * x[1] + r[8] * x[2] + tau[2] + g.t[2]};
  }
  /// g x exactly, for x over a denominator that is a multiple of translation_denominator().
  /// Requires: with |x| <= denominator, (row_sum() + 1 + |t|) * denominator is below 2^62.
  [[nodiscard]] std::array<std::int64_t, 3> apply(const Element& g, const std::array<std::int64_t, 3>& x,
                                                  std::int64_t denominator) const {
    const Linear& r = linear_[g.coset];
    std::array<std::int64_t, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = denominator / denominator_ * scaled_tau_[g.coset][i] + denominator * g.t[i];
      for (std::size_t j = 0; j < 3; ++j) result[i] += r[3 * i + j] * x[j];
    }
    return result;
  }
  /// The translation by t after a coset's representative. Throws LimitReached when it does not fit.
  [[nodiscard]] Element translated(const std::array<std::int64_t, 3>& t, std::uint16_t coset) const {
    const auto clipped = [](std::int64_t x) {
      return static_cast<int>(std::clamp<std::int64_t>(x, -100'000, 100'000));
    };
    return checked(clipped(t[0]), clipped(t[1]), clipped(t[2]), coset);
  }
  /// The linear part R_c, row by row (3 x 3, unused entries 0).
  using Linear = std::array<int, 9>;
  [[nodiscard]] const Linear& linear(int coset) const { return linear_[static_cast<std::size_t>(coset)]; }
  /// denominator * tau_c, in [0, denominator).
  [[nodiscard]] const std::array<int, 3>& scaled_tau(int coset) const {
    return scaled_tau_[static_cast<std::size_t>(coset)];
  }
  /// Largest absolute row sum of the linear parts.
  [[nodiscard]] int row_sum() const { return row_sum_; }

  /// The element as an exact map in frame coordinates, and back.
  [[nodiscard]] Isometry isometry(const Element& g) const;
  /// Requires: g in the group. Throws LimitReached when the translation does not fit.
  [[nodiscard]] Element element(const Isometry& g) const;
  /// denominator * R^-1 t in frame coordinates, t the whole translation of g: the key of the left order.
  [[nodiscard]] std::array<std::int64_t, 3> left_order_key(const Element& g) const;

 private:
  struct Product {
    std::array<int, 3> carry{};
    std::uint16_t coset = 0;
  };

  /// Apart, so that checked() is inlined.
  [[noreturn, gnu::cold]] static void throw_too_long();
  static Element checked(int x, int y, int z, std::uint16_t coset) {
    constexpr int kLimit = 32767;
    if (x > kLimit || x < -kLimit || y > kLimit || y < -kLimit || z > kLimit || z < -kLimit) throw_too_long();
    return Element{{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)},
                   coset};
  }

  int dimension_;
  int denominator_;
  int row_sum_ = 1;
  std::vector<Linear> linear_;
  std::vector<std::array<double, 3>> tau_;
  std::vector<std::array<int, 3>> scaled_tau_;
  std::vector<bool> reverses_;
  std::vector<Product> product_;  // (c,0)(c',0) = (product, carry), row c
  std::vector<Product> inverse_;  // (c,0)^-1
  std::vector<Isometry> cosets_;
};

}  // namespace flatdt::ref
