/// Exact vectors, matrices and affine maps over the carriers of flatdt/checker/exact.hpp.
/// Shapes: dimension 2 or 3; in dimension 2 the third entries (rows, columns) are 0, so most formulas ignore
/// d.
#pragma once

#include <vector>

#include "flatdt/checker/exact.hpp"

namespace flatdt::oracle {

using checker::Integer;
using checker::Rational;
using checker::Seitz;
/// A column vector in the coordinates of the instance; the first d entries count, the others are 0.
using Vector = checker::Vec<Rational>;
/// Row by row.
using Matrix = checker::Mat<Rational>;

[[nodiscard]] Vector plus(const Vector& a, const Vector& b);
[[nodiscard]] Vector minus(const Vector& a, const Vector& b);
[[nodiscard]] Vector times(const Rational& s, const Vector& a);
/// The sum of a_i b_i: a row applied to a column, not the metric's inner product.
[[nodiscard]] Rational pairing(const Vector& a, const Vector& b);
/// The vector product of coordinates: zero iff a and b are parallel.
[[nodiscard]] Vector cross(const Vector& a, const Vector& b);

[[nodiscard]] Matrix identity(int dimension);
[[nodiscard]] Vector image(const Matrix& m, const Vector& v);
[[nodiscard]] Matrix product(const Matrix& a, const Matrix& b);
[[nodiscard]] Matrix transposed(const Matrix& m);
[[nodiscard]] Rational determinant(const Matrix& m, int dimension);
/// Requires: determinant(m, dimension) != 0.
[[nodiscard]] Matrix inverse(const Matrix& m, int dimension);

/// |v|^2 = v^T metric v.
[[nodiscard]] Rational square(const Matrix& metric, const Vector& v);

[[nodiscard]] Vector image(const Seitz& g, const Vector& x);
/// g after h.
[[nodiscard]] Seitz composed(const Seitz& g, const Seitz& h);
/// Requires: g.linear invertible.
[[nodiscard]] Seitz inverse(const Seitz& g, int dimension);
[[nodiscard]] Seitz translation_by(const Vector& v, int dimension);

/// The rows p_1 - p_0, ..., p_d - p_0. Requires: d+1 points.
[[nodiscard]] Matrix edges_from_first(const std::vector<Vector>& points);
/// The volume of a simplex in coordinates, |det| / d!. Requires: d+1 points.
[[nodiscard]] Rational simplex_volume(const std::vector<Vector>& points, int dimension);

/// The point at equal distance from d+1 points, and the square of that distance.
struct Ball {
  Vector centre;
  Rational squared_radius;
};
/// Requires: the points are affinely independent.
[[nodiscard]] Ball circumscribed_ball(const std::vector<Vector>& points, const Matrix& metric, int dimension);

/// The largest integer at most x.
[[nodiscard]] Integer floor_of(const Rational& x);
/// An integer at distance at most 1/2 from x.
[[nodiscard]] Integer nearest_integer(const Rational& x);

/// "(1/2,0,3)", for messages.
[[nodiscard]] std::string to_text(const Vector& v, int dimension);

}  // namespace flatdt::oracle
