/// The points of GP near a place, by enumeration of lattice translates.
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/group.hpp"
#include "oracle/linear.hpp"

namespace flatdt::oracle {

/// A point of GP: position = element * points[point].
struct OrbitPoint {
  std::size_t point = 0;  ///< index of the input point, the least of its orbit
  Seitz element;          ///< in G; unique, since G acts freely
  Vector position;
};

/// GP for a group, a metric and finitely many points.
class OrbitPoints {
 public:
  /// Requires: the group is torsion-free and keeps the metric.
  OrbitPoints(const Group& group, const Matrix& metric, const std::vector<Vector>& points);

  /// The least index of each orbit among the points, ascending.
  [[nodiscard]] const std::vector<std::size_t>& representatives() const { return representatives_; }
  /// A short basis of the lattice.
  [[nodiscard]] const std::vector<Vector>& basis() const { return basis_; }
  /// All points of GP at the least distance from a place; at least one.   Cost: independent of how short the
  /// shortest vector is.
  [[nodiscard]] std::vector<OrbitPoint> nearest(const Vector& place) const;
  /// All points of GP whose squared distance from a place is at most `limit`.
  [[nodiscard]] std::vector<OrbitPoint> within(const Vector& place, const Rational& limit) const {
    return within(place, limit, Line::all);
  }

 private:
  /// The lattice translates of one point.
  struct Class {
    std::size_t point;
    Seitz element;
    Vector position;
    Vector coordinates;  // of the position, in the short basis
  };
  using Multiples = checker::Vec<Integer>;

  /// What is found of each line of translates along the shortest vector.
  enum class Line { all, closest };
  void enumerate(const Vector& shift, Line line, std::size_t level, const Rational& budget, Multiples& chosen,
                 std::vector<Multiples>& found) const;
  [[nodiscard]] std::vector<OrbitPoint> within(const Vector& place, const Rational& limit, Line line) const;
  [[nodiscard]] Rational greedy_square(const Vector& shift) const;
  /// Where the square of level `level` vanishes, given the multiples chosen at higher levels.
  [[nodiscard]] Rational vertex_of(const Vector& shift, std::size_t level, const Multiples& chosen) const;
  [[nodiscard]] Vector shift_of(const Class& c, const Vector& place_coordinates) const;

  int dimension_;
  Matrix metric_;
  std::vector<Vector> basis_;
  Matrix to_coordinates_;
  /// |y|^2 = sum of diagonal[i] (y_i + sum over j > i of upper[i][j] y_j)^2 for coordinates y in the short
  /// basis.
  Vector diagonal_;
  Matrix upper_;
  std::vector<std::size_t> representatives_;
  std::vector<Class> classes_;
};

}  // namespace flatdt::oracle
