#include "linear.hpp"

namespace flatdt::checker {

Mat<Rational> inverse(int d, const Mat<Rational>& a) {
  const Rational det = determinant(d, a);
  Mat<Rational> b;
  if (d == 2) {
    b[0] = {a[1][1] / det, -a[0][1] / det, 0};
    b[1] = {-a[1][0] / det, a[0][0] / det, 0};
    return b;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3;
    const std::size_t i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      b[j][i] = (a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1]) / det;
    }
  }
  return b;
}

Seitz compose(int d, const Seitz& g, const Seitz& h) {
  return {multiply(d, g.linear, h.linear), apply(d, g, h.translation)};
}

Vec<Rational> apply(int d, const Seitz& g, const Vec<Rational>& x) {
  return add(multiply(d, g.linear, x), g.translation);
}

Seitz change_basis(int d, const Seitz& g, const Mat<Rational>& basis, const Mat<Rational>& basis_inverse) {
  return {multiply(d, basis_inverse, multiply(d, g.linear, basis)),
          multiply(d, basis_inverse, g.translation)};
}

Rational squared_norm(int d, const Mat<Rational>& gram, const Vec<Rational>& v) {
  const Vec<Rational> w = multiply(d, gram, v);
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

std::string to_string(int d, const Vec<Rational>& x) {
  std::string text = "(";
  for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) text += (i == 0 ? "" : ",") + x[i].get_str();
  return text + ")";
}

std::string to_string(int d, const Seitz& g) {
  std::string text = "[";
  for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
    if (i != 0) text += ";";
    for (std::size_t j = 0; j < static_cast<std::size_t>(d); ++j)
      text += (j == 0 ? "" : ",") + g.linear[i][j].get_str();
    text += "|" + g.translation[i].get_str();
  }
  return text + "]";
}

}  // namespace flatdt::checker
