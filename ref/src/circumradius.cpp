#include "flatdt/ref/circumradius.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

namespace flatdt::ref {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Interval kUnknown{-kInfinity, kInfinity};

// Round-to-nearest errs by at most 2^-53 |x| (2^-1075 when subnormal); the margin is more than four times
// that and absorbs its own rounding. Zeros, as off the diagonal of most Gram matrices, so become numbers of
// 2^-900: with 2^-1070, as small as could be, a quarter of the time of two points on the torus went into
// subnormal operands. Rejected: nextafter, measured three times slower here.
Interval outward(double lo, double hi) {
  const Interval r{lo - (std::fabs(lo) * 0x1p-51 + 0x1p-900), hi + (std::fabs(hi) * 0x1p-51 + 0x1p-900)};
  // An overflow makes infinities and NaNs: then nothing is known.
  if (!(r.lo <= r.hi)) return {-kInfinity, kInfinity};
  return r;
}
Interval operator+(const Interval& a, const Interval& b) {
  return outward(a.lo + b.lo, a.hi + b.hi);
}
Interval operator-(const Interval& a, const Interval& b) {
  return outward(a.lo - b.hi, a.hi - b.lo);
}
Interval operator*(const Interval& a, const Interval& b) {
  const double w = a.lo * b.lo, x = a.lo * b.hi, y = a.hi * b.lo, z = a.hi * b.hi;
  if (std::isnan(w + x + y + z)) return {-kInfinity, kInfinity};
  return outward(std::min({w, x, y, z}), std::max({w, x, y, z}));
}
Interval operator/(const Interval& a, const Interval& b) {
  if (b.lo <= 0 && b.hi >= 0) return {-kInfinity, kInfinity};
  const double w = a.lo / b.lo, x = a.lo / b.hi, y = a.hi / b.lo, z = a.hi / b.hi;
  if (std::isnan(w + x + y + z)) return {-kInfinity, kInfinity};
  return outward(std::min({w, x, y, z}), std::max({w, x, y, z}));
}

// mpq_get_d rounds towards zero: one step outwards encloses.
Interval enclose_rational(const Rational& value) {
  const double x = value.to_double();
  return outward(x, x);
}

}  // namespace

template <int D>
CircumradiusConstants<D>::CircumradiusConstants(const Frame& frame)
    : threshold(frame.delta_squared * Rational(Integer(1), Integer(16))),
      threshold_interval(enclose_rational(threshold)) {
  for (const Isometry& g : frame.cosets)
    for (int i = 0; i < D; ++i) {
      Rational sum;
      for (int j = 0; j < D; ++j) sum += abs(g.linear(i, j));
      row_sum = std::max(row_sum, static_cast<double>(sum.numerator().to_long()));
    }
  const Rational determinant = frame.gram.determinant();
  const Matrix adjoint = determinant * frame.gram.inverse();
  approximate_determinant = determinant.to_double();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      const auto r = static_cast<std::size_t>(i), c = static_cast<std::size_t>(j);
      gram[r][c] = enclose_rational(frame.gram(i, j));
      approximate_gram[r][c] = frame.gram(i, j).to_double();
      approximate_adjoint[r][c] = adjoint(i, j).to_double();
      gram_sum += std::fabs(approximate_gram[r][c]);
      adjoint_sum += std::fabs(approximate_adjoint[r][c]);
    }
}

template <int D>
Interval Circumradius<D>::enclose(const Coordinates& cell, double enough) const {
  // The error of a lift's coordinate is below e = 2^-48 (rho + 1 + |x|) (filter.hpp).
  std::array<std::array<Interval, D>, D> a;
  std::array<Interval, D> q;
  for (std::size_t k = 0; k < D; ++k) {
    for (std::size_t i = 0; i < D; ++i) {
      const double x = cell[k + 1][i], y = cell[0][i];
      const double e = 2.25 * 0x1p-48 * (c_->row_sum + 1 + std::max(std::fabs(x), std::fabs(y)));
      const double difference = x - y;
      a[k][i] = outward(difference - e, difference + e);
    }
    q[k] = {};
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) q[k] = q[k] + c_->gram[i][j] * a[k][i] * a[k][j];
    if (q[k].lo >= 4 * enough) return {q[k].lo / 4, kInfinity};  // the diameter is at least an edge
  }
  // Solve 2 A z = q for z = G c by Cramer; R^2 = z^T G^-1 z.
  Interval det_g;
  std::array<std::array<Interval, D>, D> adjoint;
  std::array<Interval, D> y;
  Interval det;
  if constexpr (D == 2) {
    det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    y[0] = a[1][1] * q[0] - a[0][1] * q[1];
    y[1] = a[0][0] * q[1] - a[1][0] * q[0];
    det_g = c_->gram[0][0] * c_->gram[1][1] - c_->gram[0][1] * c_->gram[1][0];
    adjoint[0][0] = c_->gram[1][1];
    adjoint[1][1] = c_->gram[0][0];
    adjoint[0][1] = adjoint[1][0] = Interval{} - c_->gram[0][1];
  } else {
    const auto cofactor = [](const auto& m, std::size_t i, std::size_t j) {
      const std::size_t r0 = (i + 1) % 3, r1 = (i + 2) % 3, c0 = (j + 1) % 3, c1 = (j + 2) % 3;
      return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];
    };
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] = {};
      for (std::size_t k = 0; k < 3; ++k) y[i] = y[i] + cofactor(a, k, i) * q[k];
      for (std::size_t j = 0; j < 3; ++j) adjoint[i][j] = cofactor(c_->gram, i, j);
    }
    det = a[0][0] * cofactor(a, 0, 0) + a[0][1] * cofactor(a, 0, 1) + a[0][2] * cofactor(a, 0, 2);
    det_g = c_->gram[0][0] * adjoint[0][0] + c_->gram[0][1] * adjoint[0][1] + c_->gram[0][2] * adjoint[0][2];
  }
  Interval numerator{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) numerator = numerator + adjoint[i][j] * y[i] * y[j];
  return numerator / (Interval{4, 4} * det * det * det_g);
}

template <int D>
bool Circumradius<D>::is_large(const std::array<Lift, D + 1>& cell) {
  Coordinates x;
  for (std::size_t k = 0; k <= D; ++k) x[k] = cell[k].x;
  if (predicates_->uses_filter()) {
    const Interval r = enclose(x, c_->threshold_interval.hi);
    if (r.lo >= c_->threshold_interval.hi) return true;
    if (r.hi < c_->threshold_interval.lo) return false;
  }
  CellPoints<D> points;
  for (std::size_t k = 0; k <= D; ++k) points[k] = cell[k].point;
  const auto [numerator, denominator] = predicates_->exact().squared_circumradius(points);
  return numerator * c_->threshold.denominator() >= denominator * c_->threshold.numerator();
}

/// Notation: filter.hpp; u = 2^-53, eta bounds the error of an entry of A, and M the entries of A, as
/// computed and exact, and eta. With Gs = sum |G_ij|, As = sum |adj(G)_ij|:
///   q = a^T G a            |q| <= Gs M^2,       error <= e_q = Gs (2.1 eta M + 24 u M^2)
///   cofactor of A          |c| <= 2 M^2,        error <= e_c = 4.1 eta M + 8 u M^2
///   y = adj(A) q, 3 terms  |y| <= Y = 6 Gs M^4,
///                          error <= e_y = 3 (1.1 e_c Gs M^2 + 2.1 M^2 e_q) + 48 u Gs M^4
///   det A                  |det| <= 6 M^3,      error <= e_d = 3 (1.1 e_c M + 2.1 M^2 eta) + 48 u M^3
///   y^T adj(G) y           error <= As (2.1 Y e_y + 24 u Y^2)
/// In the plane the same with fewer terms. The second-order products are in the factors 1.1 and 2.1 as long
/// as eta <= M / 100. Entries of G and its adjoint and det(G) are exact up to a relative 2 u; the last factor
/// covers that and the rounding of the bounds themselves.
template <int D>
Interval Circumradius<D>::bounds(const Coordinates& cell) const {
  constexpr double u = 0x1p-53;
  std::array<std::array<double, D>, D> a;
  std::array<double, D> q;
  double m = 0;
  double x = 0;
  for (std::size_t i = 0; i < D; ++i) x = std::max(x, std::fabs(cell[0][i]));
  for (std::size_t k = 0; k < D; ++k) {
    for (std::size_t i = 0; i < D; ++i) {
      a[k][i] = cell[k + 1][i] - cell[0][i];
      m = std::max(m, std::fabs(a[k][i]));
    }
    q[k] = 0;
    for (std::size_t i = 0; i < D; ++i) {
      double row = 0;
      for (std::size_t j = 0; j < D; ++j) row += c_->approximate_gram[i][j] * a[k][j];
      q[k] += row * a[k][i];
    }
  }
  const double eta = 2.25 * 0x1p-48 * (c_->row_sum + 1 + x + m);
  m += eta;
  if (!(100 * eta <= m)) return kUnknown;
  std::array<double, D> y;
  double det = 0;
  if constexpr (D == 2) {
    det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    y = {a[1][1] * q[0] - a[0][1] * q[1], a[0][0] * q[1] - a[1][0] * q[0]};
  } else {
    std::array<std::array<double, 3>, 3> cofactor;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t r0 = (i + 1) % 3, r1 = (i + 2) % 3, c0 = (j + 1) % 3, c1 = (j + 2) % 3;
        cofactor[i][j] = a[r0][c0] * a[r1][c1] - a[r0][c1] * a[r1][c0];
      }
    for (std::size_t i = 0; i < 3; ++i)
      y[i] = cofactor[0][i] * q[0] + cofactor[1][i] * q[1] + cofactor[2][i] * q[2];
    det = a[0][0] * cofactor[0][0] + a[0][1] * cofactor[0][1] + a[0][2] * cofactor[0][2];
  }
  double numerator = 0;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) numerator += c_->approximate_adjoint[i][j] * y[i] * y[j];
  const double m2 = m * m, gm2 = c_->gram_sum * m2, bound_y = 6 * gm2 * m2;
  const double e_q = c_->gram_sum * (2.1 * eta * m + 24 * u * m2);
  const double e_c = 4.1 * eta * m + 8 * u * m2;
  const double e_y = 3 * (1.1 * e_c * gm2 + 2.1 * m2 * e_q) + 48 * u * gm2 * m2;
  const double e_d = 3 * (1.1 * e_c * m + 2.1 * m2 * eta) + 48 * u * m2 * m;
  const double e_n = c_->adjoint_sum * (2.1 * bound_y * e_y + 24 * u * bound_y * bound_y);
  const double least_det = std::fabs(det) - 1.1 * e_d;
  const double dividend = numerator + 1.1 * e_n;
  const double divisor = 4 * least_det * least_det * c_->approximate_determinant;
  // Nothing that matters has underflowed, overflowed, or is a NaN. (As and Gs are above 2^-520: det(G) is at
  // least 2^-1000.)
  const bool is_sound =
      least_det > 0 && dividend > 0x1p-900 && divisor > 0x1p-900 && dividend < 0x1p+900 && divisor < 0x1p+900;
  if (!is_sound) return kUnknown;
  const double most_det = std::fabs(det) + 1.1 * e_d;
  const double least_dividend = numerator - 1.1 * e_n;
  const double most_divisor = 4 * most_det * most_det * c_->approximate_determinant;
  const double lower = least_dividend > 0x1p-900 ? least_dividend / most_divisor * (1 - 0x1p-40) : 0;
  return {lower, dividend / divisor * (1 + 0x1p-40)};
}

/// Of the differences that congruent cells share.
struct HashOfEdges {
  template <class Edges>
  std::size_t operator()(const Edges& edges) const {
    std::uint64_t hash = 0;
    for (const auto& edge : edges)
      for (const std::int64_t x : edge) {
        hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 32U;
      }
    return hash;
  }
};

template <int D>
WidestCells<D> Circumradius<D>::widest(const QuotientComplex<D>& complex) const {
  constexpr double kTight = 0x1p-20;  // relative; of slivers the quick bounds say little
  constexpr std::size_t kFew = 8;
  const bool uses_filter = predicates_->uses_filter();
  WidestCells<D> result;
  double least = -kInfinity;  // a lower bound of the largest R^2 so far
  std::vector<double> upper;  // of each cell of the result
  std::unordered_set<typename FixedPredicates<D>::Edges, HashOfEdges> known;
  for (std::uint32_t i = 0; i < complex.cell_slots(); ++i) {
    const CellId c{i};
    if (!complex.cell(c).is_alive()) continue;
    const Coordinates x = complex.base_coordinates(c);
    Interval r = uses_filter ? bounds(x) : kUnknown;
    if (r.hi < least) continue;
    // Congruent cells, of which lattices have many, are compared once. Of few candidates it would cost more
    // to know them again: 3 % of a triangulation of two points.
    const CellPoints<D> points = complex.base_points(c);
    if (predicates_->uses_fixed() && result.cells.size() >= kFew)
      if (const auto edges = predicates_->fixed().edges(points))
        if (!known.insert(*edges).second) continue;
    if (uses_filter && (r.hi == kInfinity || r.hi - r.lo > kTight * r.hi)) r = enclose(x, kInfinity);
    if (r.hi < least) continue;
    least = std::max(least, r.lo);
    upper.push_back(r.hi);
    result.cells.push_back(points);
  }
  ensure(!upper.empty(), "a triangulation has a cell");
  std::size_t kept = 0;
  for (std::size_t i = 0; i < upper.size(); ++i)
    if (upper[i] >= least) result.cells[kept++] = result.cells[i];
  result.cells.resize(kept);
  result.squared_radius = {least, *std::max_element(upper.begin(), upper.end())};
  return result;
}

template <int D>
bool Circumradius<D>::has_large(const WidestCells<D>& widest) {
  if (widest.squared_radius.lo >= c_->threshold_interval.hi) return true;
  if (widest.squared_radius.hi < c_->threshold_interval.lo) return false;
  return squared_diameter<D>(widest.cells, predicates_->exact()) >= Rational(4) * c_->threshold;
}

template <int D>
Rational squared_diameter(const std::vector<CellPoints<D>>& cells, ExactPredicates<D>& exact) {
  ensure(!cells.empty(), "the largest ball is that of a cell");
  auto [numerator, denominator] = exact.squared_circumradius(cells.front());
  for (std::size_t i = 1; i < cells.size(); ++i) {
    auto [n, m] = exact.squared_circumradius(cells[i]);
    if (!(n * denominator > numerator * m)) continue;
    numerator = std::move(n);
    denominator = std::move(m);
  }
  return Rational(Integer(4) * numerator, denominator);
}

template Rational squared_diameter<2>(const std::vector<CellPoints<2>>&, ExactPredicates<2>&);
template Rational squared_diameter<3>(const std::vector<CellPoints<3>>&, ExactPredicates<3>&);
template struct CircumradiusConstants<2>;
template struct CircumradiusConstants<3>;
template class Circumradius<2>;
template class Circumradius<3>;

}  // namespace flatdt::ref
