// The floating-point stage of the insphere test for numbers of any size: the formula of
// Geometry::insphere_exact in balls.
#include <array>

#include "geometry.hpp"

namespace flatdt::checker {

void Geometry::make_balls(const Mat<Rational>& gram) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) gram_ball_[i][j] = to_ball(gram[i][j]);
  }
  for (const Mat<Integer>& integral : table_.group().linear) {
    Mat<Ball>& linear = linear_ball_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) linear[i][j] = to_ball(Rational(integral[i][j]));
    }
  }
  for (const LatticePoint& base : base_) {
    Vec<Ball>& ball = base_ball_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      Rational x(base.numerator[i], base.denominator);
      x.canonicalize();
      ball[i] = to_ball(x);
    }
  }
}

Vec<Ball> Geometry::ball_lift(const Lift& l) {
  const Vec<Ball>& base = base_ball_[index(l.vertex)];
  if (l.offset == kIdentity) return base;
  while (translation_ball_.size() <= index(l.offset)) {
    const Seitz g = table_.group().lattice_seitz(table_[make_id<ElementId>(translation_ball_.size())]);
    translation_ball_.push_back(
        {to_ball(g.translation[0]), to_ball(g.translation[1]), to_ball(g.translation[2])});
  }
  const Vec<Ball>& t = translation_ball_[index(l.offset)];
  const std::uint8_t rotation = table_[l.offset].rotation;
  if (rotation == 0) return {base[0] + t[0], base[1] + t[1], base[2] + t[2]};
  const Mat<Ball>& r = linear_ball_[rotation];
  Vec<Ball> out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = r[i][0] * base[0] + r[i][1] * base[1] + r[i][2] * base[2] + t[i];
  return out;
}

std::optional<Sign> Geometry::insphere_balls(const std::array<Lift, 5>& points, Sign orientation) {
  const auto n = static_cast<std::size_t>(dimension_);
  const Vec<Ball> q = ball_lift(points[n + 1]);
  std::array<Vec<Ball>, 4> p;
  std::array<Ball, 4> norm;
  for (std::size_t k = 0; k <= n; ++k) {
    const Vec<Ball> lift = ball_lift(points[k]);
    for (std::size_t i = 0; i < n; ++i) p[k][i] = lift[i] - q[i];
    for (std::size_t i = 0; i < n; ++i) {
      Ball image;
      for (std::size_t j = 0; j < n; ++j) image = image + gram_ball_[i][j] * p[k][j];
      norm[k] = norm[k] + image * p[k][i];
    }
  }
  const auto minor = [](const Ball& a, const Ball& b, const Ball& c, const Ball& e) { return a * b - c * e; };
  Ball det;
  if (n == 2) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec<Ball>& a = p[(k + 1) % 3];
      const Vec<Ball>& b = p[(k + 2) % 3];
      det = det + minor(a[0], b[1], a[1], b[0]) * norm[k];
    }
  } else {
    const auto term = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      return minor(p[i][0], p[j][1], p[i][1], p[j][0]) * minor(p[k][2], norm[l], norm[k], p[l][2]);
    };
    det = term(0, 1, 2, 3) + term(0, 2, 3, 1) + term(0, 3, 1, 2) + term(1, 2, 0, 3) + term(1, 3, 2, 0) +
          term(2, 3, 0, 1);
  }
  const std::optional<Sign> sign = certain_sign(det);
  if (!sign) return std::nullopt;
  return (orientation == Sign::positive) == (n == 2) ? *sign : opposite(*sign);
}

}  // namespace flatdt::checker
