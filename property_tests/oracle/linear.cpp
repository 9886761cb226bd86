#include "oracle/linear.hpp"

#include <string>

namespace flatdt::oracle {
namespace {

constexpr std::size_t kSize = 3;

/// In dimension 2 the matrix bordered by a 1, so that one formula serves both dimensions.
Matrix bordered(const Matrix& m, int dimension) {
  Matrix b = m;
  if (dimension == 2) b[2][2] = 1;
  return b;
}

}  // namespace

Vector plus(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector times(const Rational& s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}

Rational pairing(const Vector& a, const Vector& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < kSize; ++i)
    if (a[i] != 0 && b[i] != 0) sum += a[i] * b[i];  // linear parts are mostly zeros
  return sum;
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Matrix identity(int dimension) {
  Matrix one;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) one[i][i] = 1;
  return one;
}

Vector image(const Matrix& m, const Vector& v) {
  return {pairing(m[0], v), pairing(m[1], v), pairing(m[2], v)};
}

Matrix product(const Matrix& a, const Matrix& b) {
  const Matrix columns = transposed(b);
  Matrix result;
  for (std::size_t i = 0; i < kSize; ++i) result[i] = image(columns, a[i]);
  return result;
}

Matrix transposed(const Matrix& m) {
  Matrix result;
  for (std::size_t i = 0; i < kSize; ++i)
    for (std::size_t j = 0; j < kSize; ++j) result[i][j] = m[j][i];
  return result;
}

Rational determinant(const Matrix& m, int dimension) {
  const Matrix b = bordered(m, dimension);
  return pairing(b[0], cross(b[1], b[2]));
}

Matrix inverse(const Matrix& m, int dimension) {
  const Matrix b = bordered(m, dimension);
  const Matrix adjugate = transposed({cross(b[1], b[2]), cross(b[2], b[0]), cross(b[0], b[1])});
  const Rational scale = 1 / determinant(m, dimension);
  Matrix result;
  for (std::size_t i = 0; i < kSize; ++i) result[i] = times(scale, adjugate[i]);
  if (dimension == 2) result[2][2] = 0;
  return result;
}

Rational square(const Matrix& metric, const Vector& v) {
  return pairing(v, image(metric, v));
}

Vector image(const Seitz& g, const Vector& x) {
  return plus(image(g.linear, x), g.translation);
}

Seitz composed(const Seitz& g, const Seitz& h) {
  return {product(g.linear, h.linear), image(g, h.translation)};
}

Seitz inverse(const Seitz& g, int dimension) {
  const Matrix linear = inverse(g.linear, dimension);
  return {linear, times(-1, image(linear, g.translation))};
}

Seitz translation_by(const Vector& v, int dimension) {
  return {identity(dimension), v};
}

Matrix edges_from_first(const std::vector<Vector>& points) {
  Matrix rows;
  for (std::size_t i = 1; i < points.size(); ++i) rows[i - 1] = minus(points[i], points[0]);
  return rows;
}

Rational simplex_volume(const std::vector<Vector>& points, int dimension) {
  return abs(determinant(edges_from_first(points), dimension)) / (dimension == 2 ? 2 : 6);
}

Ball circumscribed_ball(const std::vector<Vector>& points, const Matrix& metric, int dimension) {
  // |x - p_0|^2 = |x - p_i|^2 is linear in y = x - p_0: 2 e_i^T metric y = |e_i|^2 for the edges e_i = p_i -
  // p_0.
  const Matrix edges = edges_from_first(points);
  Vector right;
  for (std::size_t i = 0; i < kSize; ++i) right[i] = square(metric, edges[i]) / 2;
  const Vector y = image(inverse(product(edges, metric), dimension), right);
  return {plus(points[0], y), square(metric, y)};
}

Integer floor_of(const Rational& x) {
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return result;
}

Integer nearest_integer(const Rational& x) {
  return floor_of(x + Rational(1, 2));
}

std::string to_text(const Vector& v, int dimension) {
  std::string text;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
    text += (i == 0 ? "(" : ",") + v[i].get_str();
  return text + ")";
}

}  // namespace flatdt::oracle
