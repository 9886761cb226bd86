/// Placement on the page and copies of cells and points.
#include <algorithm>
#include <cmath>
#include <map>

#include "flatdt/ref/errors.hpp"
#include "svg_internal.hpp"

namespace flatdt::ref::picture {
namespace {

constexpr double kMargin = 0.25;     // of the lattice cell, on all sides
constexpr double kLongSide = 900;    // page units
constexpr double kMaxCopies = 1024;  // of one cell modulo the cosets; more: far larger than the view
constexpr double kFar = 1e6;         // lattice units

/// The translations l for which [low, high] + l meets [from, to].
struct Range {
  double first, last;
  [[nodiscard]] double size() const { return std::max(0.0, last - first + 1); }
};
Range meeting(double low, double high, double from, double to) {
  return {std::ceil(from - high), std::floor(to - low)};
}

}  // namespace

Page::Page(const PictureGroup& group, const Domain& domain) : inverse_(group.inverse) {
  // The columns of the Cholesky factor of the Gram matrix. Square roots and quotients of doubles are
  // correctly rounded, so every machine gets the same.
  const double a = std::sqrt(group.gram(0, 0).to_double());
  first_ = {a, 0};
  second_ = {group.gram(0, 1).to_double() / a, std::sqrt(group.gram.determinant().to_double()) / a};
  Place low{1e300, 1e300}, high{-1e300, -1e300};
  const double u0 = domain.corner[0].to_double(), v0 = domain.corner[1].to_double();
  const double u1 = u0 + domain.sides[0].to_double(), v1 = v0 + domain.sides[1].to_double();
  for (const double u : {u0 - kMargin, u1 + kMargin}) {
    for (const double v : {v0 - kMargin, v1 + kMargin}) {
      const Place p = plain(u, v);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  scale_ = kLongSide / std::max(high.x - low.x, high.y - low.y);
  if (!std::isfinite(scale_) || scale_ <= 0 || !std::isfinite(first_[0]) || !std::isfinite(second_[0]) ||
      !std::isfinite(second_[1]))
    throw LimitReached("the cell is too large or small to be drawn");
  width_ = (high.x - low.x) * scale_;
  height_ = (high.y - low.y) * scale_;
  corner_ = {low.x, high.y};
  low_ = {1e300, 1e300};
  high_ = {-1e300, -1e300};
  for (const double x : {low.x, high.x}) {
    for (const double y : {low.y, high.y}) {
      const double v = y / second_[1], u = (x - v * second_[0]) / first_[0];
      low_ = {std::min(low_[0], u), std::min(low_[1], v)};
      high_ = {std::max(high_[0], u), std::max(high_[1], v)};
    }
  }
}

Place Page::plain(double u, double v) const {
  return {u * first_[0] + v * second_[0], u * first_[1] + v * second_[1]};
}

Place Page::place(double u, double v) const {
  const Place p = plain(u, v);
  return {(p.x - corner_.x) * scale_, (corner_.y - p.y) * scale_};
}

Place Page::place(const Vector& x) const {
  const Vector u = inverse_ * x;
  return place(u[0].to_double(), u[1].to_double());
}

bool Page::is_visible(const std::vector<Place>& places) const {
  Place low = places.front(), high = places.front();
  for (const Place& p : places) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return high.x >= 0 && low.x <= width_ && high.y >= 0 && low.y <= height_;
}

std::vector<DrawnTriangle> copies(const Simplex& triangle, const PictureGroup& group, const Domain& domain,
                                  const Page& page) {
  std::vector<DrawnTriangle> list;
  for (const Isometry& g : group.cosets) {
    const Simplex image = {g * triangle[0], g * triangle[1], g * triangle[2]};
    // Near the cell first, exactly: then small doubles place everything.
    const Vector middle = barycentre(image), shift = domain.shift_into_cell(group, middle);
    const bool in_domain = domain.contains(group.inverse * (middle + shift));
    const bool turned = g.linear.determinant().sign() == Sign::negative;
    std::array<std::array<double, 2>, 3> u{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector reduced = group.inverse * (image[k] + shift);
      u[k] = {reduced[0].to_double(), reduced[1].to_double()};
      if (!(std::abs(u[k][0]) < kFar && std::abs(u[k][1]) < kFar)) return {};
    }
    std::array<Range, 2> range{};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [low, high] = std::minmax({u[0][i], u[1][i], u[2][i]});
      range[i] = meeting(low, high, page.low()[i], page.high()[i]);
    }
    if (range[0].size() * range[1].size() > kMaxCopies) return {};
    for (int i = 0; range[0].first + i <= range[0].last; ++i) {
      const double l = range[0].first + i;
      for (int j = 0; range[1].first + j <= range[1].last; ++j) {
        const double m = range[1].first + j;
        std::vector<Place> corners(3);
        for (std::size_t k = 0; k < 3; ++k) corners[k] = page.place(u[k][0] + l, u[k][1] + m);
        if (page.is_visible(corners))
          list.push_back({std::move(corners), in_domain && l == 0 && m == 0, turned});
      }
    }
  }
  return list;
}

std::vector<DrawnPoint> point_copies(const Instance& instance, const PictureGroup& full,
                                     const PictureGroup& shown, const Domain& domain, const Page& page) {
  std::map<Vector, std::size_t> orbits;  // least point of the orbit modulo the full group, least index
  for (std::size_t i = 0; i < instance.points.size(); ++i)
    orbits.emplace(to_least(full, instance.points[i]) * instance.points[i], i);
  std::vector<std::pair<std::size_t, Vector>> sorted;
  sorted.reserve(orbits.size());
  for (const auto& [point, index] : orbits) sorted.emplace_back(index, point);
  std::sort(sorted.begin(), sorted.end());

  // The lattice of the drawn group may be coarser than that of the full group: step by the finer one.
  std::vector<DrawnPoint> list;
  const Matrix finer = shown.inverse * full.basis;
  std::array<double, 4> step{finer(0, 0).to_double(), finer(0, 1).to_double(), finer(1, 0).to_double(),
                             finer(1, 1).to_double()};
  const double det = step[0] * step[3] - step[1] * step[2];
  std::array<double, 2> low{1e300, 1e300}, high{-1e300, -1e300};  // the view in full-lattice coordinates
  for (const double u : {page.low()[0], page.high()[0]}) {
    for (const double v : {page.low()[1], page.high()[1]}) {
      const std::array<double, 2> w = {(step[3] * u - step[1] * v) / det, (step[0] * v - step[2] * u) / det};
      for (std::size_t i = 0; i < 2; ++i) {
        low[i] = std::min(low[i], w[i]);
        high[i] = std::max(high[i], w[i]);
      }
    }
  }
  if (!((high[0] - low[0]) * (high[1] - low[1]) < 1e5))
    throw LimitReached("too many copies of the cell in view");
  // A product can be small while one side is beyond any integer.
  for (std::size_t i = 0; i < 2; ++i)
    if (!(std::abs(low[i]) < 1e9 && std::abs(high[i]) < 1e9))
      throw LimitReached("too many copies of the cell in view");
  const auto first = [&](std::size_t i) { return static_cast<long>(std::floor(low[i])) - 1; };
  const auto last = [&](std::size_t i) { return static_cast<long>(std::ceil(high[i])) + 1; };
  for (const auto& [index, point] : sorted) {
    for (const Isometry& g : full.cosets) {
      const Vector image = g * point, start = image + shift_into_cell(full, image);
      const Vector reduced = shown.inverse * start;
      const std::array<double, 2> u = {reduced[0].to_double(), reduced[1].to_double()};
      for (long l = first(0); l <= last(0); ++l) {
        for (long m = first(1); m <= last(1); ++m) {
          const auto dl = static_cast<double>(l), dm = static_cast<double>(m);
          const Place place =
              page.place(u[0] + dl * step[0] + dm * step[1], u[1] + dl * step[2] + dm * step[3]);
          if (!page.is_visible({place})) continue;
          const Vector x = start + Rational(l) * full.basis.column(0) + Rational(m) * full.basis.column(1);
          list.push_back({place, index, domain.contains(shown.inverse * x)});
        }
      }
    }
  }
  return list;
}

}  // namespace flatdt::ref::picture
