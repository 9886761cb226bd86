/// Witnesses that are drawn: a loop or 2-cycle of the quotient, a disk with a point inside. Decided exactly,
/// and from the points in the plane alone: the elements of a wrong triangulation may lie outside the group.
#include <map>

#include "svg_internal.hpp"

namespace flatdt::ref::svg_detail {
namespace {

/// Twice the circumcentre c of a triangle solves <p_k - p_0, 2c - 2 p_0> = |p_k - p_0|^2 for k = 1, 2.
std::optional<Vector> circumcentre(const Matrix& gram, const Triangle& t) {
  const Vector a = t[1] - t[0], b = t[2] - t[0];
  Matrix rows(2);
  const Vector ga = gram * a, gb = gram * b;
  for (int j = 0; j < 2; ++j) {
    rows(0, j) = ga[j];
    rows(1, j) = gb[j];
  }
  if (rows.determinant().is_zero()) return std::nullopt;
  Vector right(2);
  right[0] = squared_length(gram, a);
  right[1] = squared_length(gram, b);
  return t[0] + Rational(Integer(1), Integer(2)) * (rows.inverse() * right);
}

}  // namespace

std::optional<Cycle> find_cycle(const std::vector<Triangle>& triangles, const PlaneGroup& group) {
  // Of an edge between two orbits: its lift from the least point of the one with the lesser least point. The
  // group acts freely, so two edges are one modulo the group iff these lifts are equal.
  std::map<std::pair<Vector, Vector>, Vector> edges;  // least points of both orbits -> far end of the lift
  std::optional<Cycle> cycle;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector &x = t[k], &y = t[(k + 1) % 3];
      if (x == y) continue;
      const Isometry gx = to_least(group, x), gy = to_least(group, y);
      const Vector least_x = gx * x, least_y = gy * y;
      if (least_x == least_y) return Cycle{true, x, y, y};
      const bool from_x = least_x < least_y;
      const Vector far_end = from_x ? gx * y : gy * x;
      const auto key = from_x ? std::make_pair(least_x, least_y) : std::make_pair(least_y, least_x);
      const auto [where, is_new] = edges.emplace(key, far_end);
      if (!is_new && where->second != far_end && !cycle)
        cycle = Cycle{false, key.first, where->second, far_end};
    }
  }
  return cycle;
}

std::optional<Violation> find_violation(const Instance& instance, const std::vector<Triangle>& triangles,
                                        const PlaneGroup& group) {
  const Matrix& gram = instance.gram;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const std::optional<Vector> centre = circumcentre(gram, triangles[k]);
    if (!centre) continue;
    const Rational radius_squared = squared_length(gram, triangles[k][0] - *centre);
    std::optional<Violation> deepest;
    for (std::size_t i = 0; i < instance.points.size(); ++i) {
      for (const Isometry& g : group.cosets) {
        // The nearest image of a point is at a corner of the cell that holds the centre: the basis is
        // reduced.
        const Vector image = g * instance.points[i];
        const Vector near = image - shift_into_cell(group, *centre - image);
        for (int corner = 0; corner < 4; ++corner) {
          Vector step(2);
          step[0] = corner % 2;
          step[1] = corner / 2;
          const Vector x = near + group.basis * step;
          const Rational distance_squared = squared_length(gram, x - *centre);
          if (distance_squared >= radius_squared) continue;
          if (deepest && distance_squared >= deepest->distance_squared) continue;
          deepest = Violation{k, i, *centre, x, radius_squared, distance_squared};
        }
      }
    }
    if (deepest) return deepest;
  }
  return std::nullopt;
}

}  // namespace flatdt::ref::svg_detail
