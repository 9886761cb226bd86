#include "fixed_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace flatdt::checker {
namespace {

/// a b - c e.   Bound: below 2^125 for factors below 2^62.
Wide<2> cross(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t e) {
  return wide(a) * wide(b) - wide(c) * wide(e);
}

Vec<std::int64_t> difference(const Vec<std::int64_t>& a, const Vec<std::int64_t>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Rows (i, j) in the first two columns against the rows (k, l) in the last two: all even permutations.
constexpr std::array<std::array<std::size_t, 4>, 6> kSplits = {
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

}  // namespace

std::optional<FixedGeometry> FixedGeometry::make(const Complex& complex, const Orbits& orbits,
                                                 const ElementTable& table, const Mat<Integer>& gram) {
  if (!orbits.fixed) return std::nullopt;
  const Group& group = table.group();
  FixedGeometry geometry;
  geometry.dimension_ = static_cast<std::size_t>(group.dimension);
  geometry.denominator_ = orbits.fixed->denominator;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::optional<std::int64_t> entry = to_fixed(gram[i][j]);
      if (!entry) return std::nullopt;
      geometry.gram_[i][j] = *entry;
      geometry.gram_double_[i][j] = static_cast<double>(*entry);
      geometry.gram_magnitude_[i][j] = std::fabs(geometry.gram_double_[i][j]);
    }
  }
  std::int64_t most = 0;
  std::optional<FixedMap> map;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    const auto& [orbit, coset] = complex.vertices[v];
    if (v == 0 || complex.vertices[v - 1].coset != coset) {  // canonical points are in the unit cell
      map = fixed_map(group, table[coset], geometry.denominator_, geometry.denominator_);
      if (!map) return std::nullopt;
    }
    const Point& x = geometry.base_.emplace_back((*map)(orbits.fixed->numerator[index(orbit)]));
    for (const std::int64_t coordinate : x) most = std::max(most, std::abs(coordinate));
  }
  for (std::size_t id = 0; id < table.size(); ++id) {
    geometry.maps_.push_back(fixed_map(group, table[make_id<ElementId>(id)], geometry.denominator_, most));
  }
  return geometry;
}

inline bool FixedGeometry::lift(const Lift& l, Point& out) const {
  out = base_[index(l.vertex)];
  if (l.offset == kIdentity) return true;
  if (index(l.offset) >= maps_.size() || !maps_[index(l.offset)]) return false;
  out = (*maps_[index(l.offset)])(out);
  return true;
}

std::optional<Wide<3>> FixedGeometry::determinant(const std::array<Lift, 4>& cell) const {
  std::array<Point, 4> p;
  for (std::size_t k = 0; k <= dimension_; ++k) {
    if (!lift(cell[k], p[k])) return std::nullopt;
  }
  for (std::size_t k = 1; k <= dimension_; ++k) p[k] = difference(p[k], p[0]);
  const Wide<2> xy = cross(p[1][0], p[2][1], p[1][1], p[2][0]);
  if (dimension_ == 2) return xy.widened<3>();
  const Wide<2> yz = cross(p[1][1], p[2][2], p[1][2], p[2][1]);
  const Wide<2> zx = cross(p[1][2], p[2][0], p[1][0], p[2][2]);
  // Three products below 2^187.
  return xy * wide(p[3][2]) + yz * wide(p[3][0]) + zx * wide(p[3][1]);
}

// Laplace expansion by the first two columns against the last two (3D), or along the last column (2D).
// Bound: the determinant is a sum of at most 24 products of three coordinates and a norm, with at most 22
// roundings each; 24 * 22 u is well below 2^-43.
template <std::size_t D>
std::optional<Sign> FixedGeometry::sign_by_doubles(const Rows& rows) const {
  std::array<std::array<double, D + 1>, D> p;  // by coordinates, so that two rows are computed at a time
  std::array<double, D + 1> norm{};
  std::array<double, D> most{};
  for (std::size_t i = 0; i < D; ++i) {
    for (std::size_t k = 0; k <= D; ++k) p[i][k] = static_cast<double>(rows[k][i]);
    for (std::size_t k = 0; k <= D; ++k) most[i] = std::max(most[i], std::fabs(p[i][k]));
  }
  for (std::size_t i = 0; i < D; ++i) {
    for (std::size_t k = 0; k <= D; ++k) {
      double image = 0;
      for (std::size_t j = 0; j < D; ++j) image += gram_double_[i][j] * p[j][k];
      norm[k] += image * p[i][k];
    }
  }
  double bound = 0;  // of all norms, then of all products
  for (std::size_t i = 0; i < D; ++i) {
    double image = 0;
    for (std::size_t j = 0; j < D; ++j) image += gram_magnitude_[i][j] * most[j];
    bound += image * most[i];
  }
  for (std::size_t i = 0; i < D; ++i) bound *= most[i];
  double det = 0;
  if constexpr (D == 2) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3;
      const std::size_t b = (k + 2) % 3;
      det += (p[0][a] * p[1][b] - p[1][a] * p[0][b]) * norm[k];
    }
  } else {
    for (const auto& [i, j, k, l] : kSplits) {
      det += (p[0][i] * p[1][j] - p[1][i] * p[0][j]) * (p[2][k] * norm[l] - norm[k] * p[2][l]);
    }
  }
  constexpr double kExact = 0x1p48;  // 24 * 2^48 < 2^53: all values are integers that a double holds
  constexpr double kError = 0x1p-43;
  const bool exact = bound < kExact;
  if (!exact && std::fabs(det) <= kError * bound) return std::nullopt;
  return det > 0 ? Sign::positive : det < 0 ? Sign::negative : Sign::zero;
}

// Bounds: the inner sum is below 3 * 2^124 < 2^126, the norm below 3 * 2^126 * 2^62 < 2^190.
FixedGeometry::Norm FixedGeometry::squared_norm(const Point& v) const {
  Norm norm;
  for (std::size_t i = 0; i < dimension_; ++i) {
    Wide<2> image;
    for (std::size_t j = 0; j < dimension_; ++j) image = image + wide(gram_[i][j]) * wide(v[j]);
    norm = norm + image * wide(v[i]);
  }
  return norm;
}

// Bounds: with squared_norm's, the minors are below 2^125 and 2^253, and the sum below 6 * 2^378 < 2^381.
template <std::size_t D>
Sign FixedGeometry::sign_by_limbs(const Rows& rows) const {
  std::array<Norm, D + 1> norm;
  for (std::size_t k = 0; k <= D; ++k) norm[k] = squared_norm(rows[k]);
  const auto minor = [&](std::size_t i, std::size_t j) {
    return cross(rows[i][0], rows[j][1], rows[i][1], rows[j][0]);
  };
  if constexpr (D == 2) {
    return sign_of(minor(1, 2) * norm[0] + minor(2, 0) * norm[1] + minor(0, 1) * norm[2]);
  } else {
    Wide<6> det;
    for (const auto& [i, j, k, l] : kSplits) {
      det = det + minor(i, j) * (wide(rows[k][2]) * norm[l] - wide(rows[l][2]) * norm[k]);
    }
    return sign_of(det);
  }
}

template <std::size_t D>
FixedGeometry::Answer FixedGeometry::answer(const std::array<Lift, 5>& points, Sign orientation,
                                            FixedStage stage) const {
  Rows rows;
  Point q;
  if (!lift(points[D + 1], q)) return std::nullopt;
  for (std::size_t k = 0; k <= D; ++k) {
    if (!lift(points[k], rows[k])) return std::nullopt;
    rows[k] = difference(rows[k], q);
  }
  std::optional<Sign> sign;
  if (stage != FixedStage::limbs) sign = sign_by_doubles<D>(rows);
  if (!sign && stage != FixedStage::doubles) sign = sign_by_limbs<D>(rows);
  // The sign of orientation * (-1)^d det.
  if (!sign) return std::nullopt;
  return (orientation == Sign::positive) == (D == 2) ? *sign : opposite(*sign);
}

FixedGeometry::Answer FixedGeometry::insphere(const std::array<Lift, 5>& points, Sign orientation,
                                              FixedStage stage) const {
  return dimension_ == 2 ? answer<2>(points, orientation, stage) : answer<3>(points, orientation, stage);
}

}  // namespace flatdt::checker
