#include "oracle/orbit_points.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace flatdt::oracle {

OrbitPoints::OrbitPoints(const Group& group, const Matrix& metric, const std::vector<Vector>& points)
    : dimension_(group.dimension), metric_(metric), basis_(short_basis(group.lattice, metric)) {
  const auto d = static_cast<std::size_t>(dimension_);
  Matrix rows;
  for (std::size_t i = 0; i < d; ++i) rows[i] = basis_[i];
  to_coordinates_ = inverse(transposed(rows), dimension_);

  // Completing squares from the first coordinate on.
  Matrix gram = product(rows, product(metric, transposed(rows)));
  for (std::size_t i = 0; i < d; ++i) {
    diagonal_[i] = gram[i][i];
    for (std::size_t j = i + 1; j < d; ++j) upper_[i][j] = gram[i][j] / gram[i][i];
    for (std::size_t j = i + 1; j < d; ++j)
      for (std::size_t k = i + 1; k < d; ++k) gram[j][k] -= diagonal_[i] * upper_[i][j] * upper_[i][k];
  }

  std::set<Vector> seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!seen.insert(group.canonical(points[i]).first).second) continue;
    representatives_.push_back(i);
    for (const Seitz& c : group.cosets) {
      const Vector position = image(c, points[i]);
      classes_.push_back({i, c, position, image(to_coordinates_, position)});
    }
  }
}

Vector OrbitPoints::shift_of(const Class& c, const Vector& place_coordinates) const {
  return minus(c.coordinates, place_coordinates);
}

Rational OrbitPoints::vertex_of(const Vector& shift, std::size_t level, const Multiples& chosen) const {
  Rational at = -shift[level];
  for (std::size_t j = level + 1; j < static_cast<std::size_t>(dimension_); ++j)
    at -= upper_[level][j] * (chosen[j] + shift[j]);
  return at;
}

/// All n with |n + shift|^2 at most the budget, where coordinates above `level` are chosen and paid for; of
/// those that differ in the last coordinate alone, perhaps only the nearest.
void OrbitPoints::enumerate(const Vector& shift, Line line, std::size_t level, const Rational& budget,
                            Multiples& chosen, std::vector<Multiples>& found) const {
  const Rational vertex = vertex_of(shift, level, chosen);
  const Integer start = floor_of(vertex);
  if (level == 0 && line == Line::closest) {
    const Rational below = vertex - start;
    const Rational above = 1 - below;
    for (const bool next : {false, true}) {
      const Rational& off = next ? above : below;
      if (off > (next ? below : above) || diagonal_[0] * off * off > budget) continue;
      chosen[0] = next ? Integer(start + 1) : start;
      found.push_back(chosen);
    }
    return;
  }
  for (const int step : {-1, 1}) {
    for (Integer n = step < 0 ? start : Integer(start + 1);; n += step) {
      const Rational off = n - vertex;
      const Rational rest = budget - diagonal_[level] * off * off;
      if (rest < 0) break;  // the square grows in this direction
      chosen[level] = n;
      if (level == 0)
        found.push_back(chosen);
      else
        enumerate(shift, line, level - 1, rest, chosen, found);
    }
  }
}

/// |n + shift|^2 for some n, small: each coordinate rounded to where its square is least.
Rational OrbitPoints::greedy_square(const Vector& shift) const {
  Multiples chosen;
  Rational sum = 0;
  for (auto level = static_cast<std::size_t>(dimension_); level-- > 0;) {
    const Rational vertex = vertex_of(shift, level, chosen);
    chosen[level] = nearest_integer(vertex);
    const Rational off = chosen[level] - vertex;
    sum += diagonal_[level] * off * off;
  }
  return sum;
}

std::vector<OrbitPoint> OrbitPoints::within(const Vector& place, const Rational& limit, Line line) const {
  const Vector at = image(to_coordinates_, place);
  std::vector<OrbitPoint> result;
  for (const Class& c : classes_) {
    Multiples chosen;
    std::vector<Multiples> found;
    enumerate(shift_of(c, at), line, static_cast<std::size_t>(dimension_) - 1, limit, chosen, found);
    for (const Multiples& n : found) {
      Vector v{};
      for (std::size_t i = 0; i < basis_.size(); ++i) v = plus(v, times(n[i], basis_[i]));
      result.push_back({c.point, {c.element.linear, plus(c.element.translation, v)}, plus(c.position, v)});
    }
  }
  return result;
}

std::vector<OrbitPoint> OrbitPoints::nearest(const Vector& place) const {
  const Vector at = image(to_coordinates_, place);
  std::optional<Rational> limit;
  for (const Class& c : classes_) {
    const Rational s = greedy_square(shift_of(c, at));
    if (!limit || s < *limit) limit = s;
  }
  std::vector<OrbitPoint> result;
  std::optional<Rational> least;
  for (OrbitPoint& p : within(place, *limit, Line::closest)) {
    const Rational s = square(metric_, minus(p.position, place));
    if (least && s > *least) continue;
    if (!least || s < *least) result.clear();
    least = s;
    result.push_back(std::move(p));
  }
  return result;
}

}  // namespace flatdt::oracle
