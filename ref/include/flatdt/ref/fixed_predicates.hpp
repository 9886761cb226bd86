/// Fixed-width stage of the predicates: integers of 64, 128 or up to 384 bits over one common denominator;
/// nothing when the numbers of this instance or of this call do not fit. Certain or silent; allocates
/// nothing.
///
/// Bounds. The coordinates of p_k - w over the common denominator are integers below 2^b; the Gram matrix
/// over its own is integers below 2^g. Then, in d <= 3 dimensions,
///   a 2 x 2 minor of two coordinate columns is below 2^(2b+1),
///   a squared length sum_ij G_ij a_i a_j (9 terms) below 2^(2b+g+4),
///   a 2 x 2 minor of a coordinate and the length column below 2^(3b+g+5),
///   the insphere determinant, 6 products of two such minors in space, below 2^(5b+g+9); in the plane 3
///   products of a minor and a length: below 2^(4b+g+7);
///   the orientation determinant below 2^(3b+3).
/// Narrow form: lengths in 64 bits and the determinant in 128 if 2b+g+4 <= 63 and 5b+g+9 <= 127.
/// Middle form, if 2b+g+4 <= 127, and so b <= 61: lengths in 128 bits, mixed minors below 2^(127+b+1) <=
/// 2^189 (192 bits), the determinant below 2^(127+3b+5) <= 2^315 (320 bits), in the plane below 2^(127+2b+3)
/// <= 2^252 (256 bits). Wide form: b, g <= 62, hence minors below 2^125 (128 bits), lengths below 2^190 (192
/// bits), mixed minors below 2^253 (256 bits), the determinant below 2^381 (384 bits).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flatdt/ref/exact_predicates.hpp"
#include "flatdt/ref/wide_integer.hpp"

namespace flatdt::ref {

/// The Gram matrix in machine integers, cleared of denominators.
template <int D>
struct FixedMetric {
  explicit FixedMetric(const Frame& frame);
  /// <a, a>. Requires: the entries of a are below 2^62.
  [[nodiscard]] WideInteger<3> squared_length(const std::array<std::int64_t, D>& a) const;

  bool fits = false;  // all entries are below 2^62
  int bits = 0;       // and below 2^bits
  std::array<std::array<std::int64_t, D>, D> gram{};
};

template <int D>
class FixedPredicates {
 public:
  FixedPredicates(const Frame& frame, const GroupTable& table, const std::vector<Site>& sites)
      : FixedPredicates(FixedMetric<D>(frame), table, sites) {}
  FixedPredicates(const FixedMetric<D>& metric, const GroupTable& table, const std::vector<Site>& sites);

  /// Sign of det(p_1 - p_0, ..., p_D - p_0), if the numbers fit.
  [[nodiscard]] std::optional<Sign> orientation(const std::array<OrbitPoint, D + 1>& p) const;
  /// Sign of (-1)^D times the determinant of the rows (p_k - w, |p_k - w|^2), if the numbers fit.
  [[nodiscard]] std::optional<Sign> insphere(const std::array<OrbitPoint, D + 1>& p,
                                             const OrbitPoint& w) const;

  using Row = std::array<std::int64_t, D>;
  /// The edges p_k - p_0 of a cell over the common denominator: two cells with the same are translates.
  using Edges = std::array<Row, D>;
  [[nodiscard]] std::optional<Edges> edges(const std::array<OrbitPoint, D + 1>& p) const;
  /// p - from over the common denominator, below 2^62, if the numbers fit.
  [[nodiscard]] std::optional<Row> difference(const OrbitPoint& p, const OrbitPoint& from) const;
  [[nodiscard]] const FixedMetric<D>& metric() const { return metric_; }

 private:
  /// rows[k] = common * (p_k - w); returns the least b with all entries below 2^b, or nothing if b > 62 or a
  /// site has another denominator.
  template <std::size_t Count>
  [[nodiscard]] std::optional<int> load(const OrbitPoint* p, const OrbitPoint& w,
                                        std::array<Row, Count>& rows) const;

  const GroupTable* table_;
  const std::vector<Site>* sites_;
  bool enabled_ = false;
  std::int64_t denominator_ = 0;
  std::int64_t unit_ = 0;  // denominator / translation denominator
  FixedMetric<D> metric_;
};

extern template struct FixedMetric<2>;
extern template struct FixedMetric<3>;
extern template class FixedPredicates<2>;
extern template class FixedPredicates<3>;

}  // namespace flatdt::ref
