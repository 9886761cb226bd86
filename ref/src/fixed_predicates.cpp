#include "flatdt/ref/fixed_predicates.hpp"

#include <bit>

#include "flatdt/ref/wide_integer.hpp"

namespace flatdt::ref {
namespace {

constexpr int kMaxBits = 62;

Sign sign_of(Int128 x) {
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

/// The six pairs of complementary 2 x 2 minors of a 4 x 4 determinant's first two and last two columns.
constexpr std::array<std::array<std::size_t, 4>, 6> kPairs{
    {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
constexpr std::array<bool, 6> kNegative{false, true, false, false, true, false};

template <class Row>
Int128 minor(const Row& a, const Row& b) {
  return static_cast<Int128>(a[0]) * b[1] - static_cast<Int128>(a[1]) * b[0];
}

/// Narrow form: the determinant times (-1)^D.
template <int D, class Rows, class Gram>
Sign narrow_insphere(const Rows& rows, const Gram& gram) {
  std::array<std::int64_t, D + 1> length{};
  for (std::size_t k = 0; k <= D; ++k)
    for (std::size_t i = 0; i < D; ++i) {
      std::int64_t row = 0;
      for (std::size_t j = 0; j < D; ++j) row += gram[i][j] * rows[k][j];
      length[k] += row * rows[k][i];
    }
  const auto small_minor = [&rows](std::size_t r, std::size_t s) {
    return rows[r][0] * rows[s][1] - rows[r][1] * rows[s][0];
  };
  if constexpr (D == 2) {
    return sign_of(static_cast<Int128>(small_minor(1, 2)) * length[0] -
                   static_cast<Int128>(small_minor(0, 2)) * length[1] +
                   static_cast<Int128>(small_minor(0, 1)) * length[2]);
  } else {
    Int128 determinant = 0;
    for (std::size_t k = 0; k < 6; ++k) {
      const std::size_t r = kPairs[k][2], s = kPairs[k][3];
      const Int128 mixed =
          static_cast<Int128>(rows[r][2]) * length[s] - static_cast<Int128>(rows[s][2]) * length[r];
      const Int128 term = small_minor(kPairs[k][0], kPairs[k][1]) * mixed;
      determinant += kNegative[k] ? -term : term;
    }
    return -sign_of(determinant);
  }
}

/// Wide forms: the determinant times (-1)^D, the lengths in L limbs.
template <int D, std::size_t L, class Rows>
WideInteger<L + D> wide_insphere(const Rows& rows, const std::array<WideInteger<L>, D + 1>& length) {
  WideInteger<L + D> determinant;
  if constexpr (D == 2) {
    determinant = multiply(widened<2>(minor(rows[1], rows[2])), length[0]);
    determinant -= multiply(widened<2>(minor(rows[0], rows[2])), length[1]);
    determinant += multiply(widened<2>(minor(rows[0], rows[1])), length[2]);
    return determinant;
  } else {
    for (std::size_t k = 0; k < 6; ++k) {
      const std::size_t r = kPairs[k][2], s = kPairs[k][3];
      WideInteger<L + 1> mixed =
          multiply(WideInteger<1>{{static_cast<std::uint64_t>(rows[r][2])}}, length[s]);
      mixed -= multiply(WideInteger<1>{{static_cast<std::uint64_t>(rows[s][2])}}, length[r]);
      const auto term = multiply(widened<2>(minor(rows[kPairs[k][0]], rows[kPairs[k][1]])), mixed);
      if (kNegative[k])
        determinant -= term;
      else
        determinant += term;
    }
    return -determinant;
  }
}

/// Requires: the squared length is below 2^127.
template <int D, class Gram>
Int128 squared_length(const Gram& gram, const std::array<std::int64_t, D>& a) {
  Int128 length = 0;
  for (std::size_t i = 0; i < D; ++i) {
    Int128 row = 0;
    for (std::size_t j = 0; j < D; ++j) row += static_cast<Int128>(gram[i][j]) * a[j];
    length += row * a[i];
  }
  return length;
}

template <int D, class Rows>
Sign insphere_sign(const Rows& rows, int bits, const FixedMetric<D>& metric) {
  if (2 * bits + metric.bits + 4 <= 63 && 5 * bits + metric.bits + 9 <= 127)
    return narrow_insphere<D>(rows, metric.gram);
  if (2 * bits + metric.bits + 4 <= 127) {
    std::array<WideInteger<2>, D + 1> length;
    for (std::size_t k = 0; k <= D; ++k) length[k] = widened<2>(squared_length<D>(metric.gram, rows[k]));
    return wide_insphere<D, 2>(rows, length).sign();
  }
  std::array<WideInteger<3>, D + 1> length;
  for (std::size_t k = 0; k <= D; ++k) length[k] = metric.squared_length(rows[k]);
  return wide_insphere<D, 3>(rows, length).sign();
}

}  // namespace

template <int D>
FixedMetric<D>::FixedMetric(const Frame& frame) {
  Integer common = 1;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) common = lcm(common, frame.gram(i, j).denominator());
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      const Integer entry = (Rational(common) * frame.gram(i, j)).numerator();
      const auto entry_bits = static_cast<int>(entry.is_zero() ? 0 : entry.bits());
      if (entry_bits > kMaxBits) return;
      bits = std::max(bits, entry_bits);
      gram[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = entry.to_long();
    }
  fits = true;
}

template <int D>
WideInteger<3> FixedMetric<D>::squared_length(const std::array<std::int64_t, D>& a) const {
  WideInteger<3> length;
  for (std::size_t i = 0; i < D; ++i) {
    Int128 row = 0;  // below 2^(g+b+2) <= 2^126
    for (std::size_t j = 0; j < D; ++j) row += static_cast<Int128>(gram[i][j]) * a[j];
    const WideInteger<4> term = multiply(widened<2>(row), widened<2>(a[i]));
    length += WideInteger<3>{{term.limb[0], term.limb[1], term.limb[2]}};
  }
  return length;
}

template <int D>
FixedPredicates<D>::FixedPredicates(const FixedMetric<D>& metric, const GroupTable& table,
                                    const std::vector<Site>& sites)
    : table_(&table), sites_(&sites), metric_(metric) {
  if (!metric.fits || sites.empty() || sites[0].is_large()) return;
  denominator_ = sites[0].form->small_denominator;
  unit_ = denominator_ / table.translation_denominator();
  enabled_ = true;
}

template <int D>
template <std::size_t Count>
std::optional<int> FixedPredicates<D>::load(const OrbitPoint* p, const OrbitPoint& w,
                                            std::array<Row, Count>& rows) const {
  // A numerator is below 2^62, a row sum of a linear part and a translation below 2^16: below 2^80.
  const auto coordinate = [this](const OrbitPoint& at, const Site& site, std::size_t i) {
    const std::int64_t shift =
        table_->scaled_tau(at.g.coset)[i] + std::int64_t{table_->translation_denominator()} * at.g.t[i];
    if (at.g.coset == 0) return site.small[i] + static_cast<Int128>(unit_) * shift;
    const GroupTable::Linear& linear = table_->linear(at.g.coset);
    Int128 x = static_cast<Int128>(unit_) * shift;
    for (std::size_t j = 0; j < D; ++j) x += static_cast<Int128>(site.small[j]) * linear[3 * i + j];
    return x;
  };
  const Site& centre = (*sites_)[index_of(w.site)];
  if (centre.form->small_denominator != denominator_) return std::nullopt;
  std::uint64_t any = 0;  // its bits bound the magnitudes of all entries
  for (std::size_t k = 0; k < Count; ++k) {
    const Site& site = (*sites_)[index_of(p[k].site)];
    if (site.form->small_denominator != denominator_) return std::nullopt;
    // By translations alone: the difference of two numbers below 2^62, and of whole periods.
    const bool is_translated = (p[k].g.coset | w.g.coset) == 0;
    for (std::size_t i = 0; i < D; ++i) {
      const Int128 difference =
          is_translated ? site.small[i] - centre.small[i] +
                              static_cast<Int128>(denominator_) * (std::int64_t{p[k].g.t[i]} - w.g.t[i])
                        : coordinate(p[k], site, i) - coordinate(w, centre, i);
      rows[k][i] = static_cast<std::int64_t>(difference);
      if (difference != rows[k][i]) return std::nullopt;
      const auto entry = static_cast<std::uint64_t>(rows[k][i]);
      any |= rows[k][i] < 0 ? 0 - entry : entry;
    }
  }
  const int bits = std::bit_width(any);
  return bits <= kMaxBits ? std::optional(bits) : std::nullopt;
}

template <int D>
std::optional<Sign> FixedPredicates<D>::orientation(const std::array<OrbitPoint, D + 1>& p) const {
  if (!enabled_) return std::nullopt;
  std::array<Row, D> rows;
  const std::optional<int> bits = load<D>(p.data() + 1, p[0], rows);
  if (!bits) return std::nullopt;
  if constexpr (D == 2) {
    return sign_of(minor(rows[0], rows[1]));
  } else {
    if (3 * *bits + 3 <= 127)
      return sign_of(minor(rows[0], rows[1]) * rows[2][2] - minor(rows[0], rows[2]) * rows[1][2] +
                     minor(rows[1], rows[2]) * rows[0][2]);
    const auto term = [&rows](std::size_t r, std::size_t s, std::size_t t) {
      return multiply(widened<2>(minor(rows[r], rows[s])),
                      WideInteger<1>{{static_cast<std::uint64_t>(rows[t][2])}});
    };
    WideInteger<3> determinant = term(0, 1, 2);
    determinant -= term(0, 2, 1);
    determinant += term(1, 2, 0);
    return determinant.sign();
  }
}

template <int D>
std::optional<Sign> FixedPredicates<D>::insphere(const std::array<OrbitPoint, D + 1>& p,
                                                 const OrbitPoint& w) const {
  if (!enabled_) return std::nullopt;
  std::array<Row, D + 1> rows;
  const std::optional<int> bits = load<D + 1>(p.data(), w, rows);
  if (!bits) return std::nullopt;
  return insphere_sign<D>(rows, *bits, metric_);
}

template <int D>
std::optional<typename FixedPredicates<D>::Edges> FixedPredicates<D>::edges(
    const std::array<OrbitPoint, D + 1>& p) const {
  Edges edges;
  if (!enabled_ || !load<D>(p.data() + 1, p[0], edges)) return std::nullopt;
  return edges;
}

template <int D>
std::optional<typename FixedPredicates<D>::Row> FixedPredicates<D>::difference(const OrbitPoint& p,
                                                                               const OrbitPoint& from) const {
  std::array<Row, 1> row;
  if (!enabled_ || !load<1>(&p, from, row)) return std::nullopt;
  return row[0];
}

template struct FixedMetric<2>;
template struct FixedMetric<3>;
template class FixedPredicates<2>;
template class FixedPredicates<3>;

}  // namespace flatdt::ref
