#include "geometry.hpp"

namespace flatdt::property_tests {

using ref::Matrix;
using ref::Rational;
using ref::Vector;

std::optional<Sphere> circumsphere(const Matrix& gram, const std::vector<Vector>& points) {
  const int d = gram.dimension();
  Matrix rows(d);
  Vector lengths(d);
  for (int k = 0; k < d; ++k) {
    const Vector a = points[static_cast<std::size_t>(k) + 1] - points[0];
    const Vector ga = gram * a;
    for (int j = 0; j < d; ++j) rows(k, j) = Rational(2) * ga[j];
    lengths[k] = inner_product(gram, a, a);
  }
  if (rows.determinant().is_zero()) return std::nullopt;
  const Vector c = rows.inverse() * lengths;
  return Sphere{points[0] + c, squared_length(gram, c)};
}

ref::Sign orientation(const std::vector<Vector>& points) {
  const int d = points[0].dimension();
  Matrix rows(d);
  for (int k = 0; k < d; ++k)
    for (int j = 0; j < d; ++j) rows(k, j) = points[static_cast<std::size_t>(k) + 1][j] - points[0][j];
  return rows.determinant().sign();
}

}  // namespace flatdt::property_tests
