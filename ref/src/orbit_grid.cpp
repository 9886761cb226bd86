#include "orbit_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace flatdt::ref::picture {
namespace {

/// About one image of a point in each bucket.
long size_for(std::size_t images) {
  constexpr double kMostInADirection = 1024;
  return static_cast<long>(
      std::clamp(std::ceil(std::sqrt(static_cast<double>(images))), 1.0, kMostInADirection));
}

}  // namespace

OrbitGrid::OrbitGrid(const Instance& instance, const PictureGroup& group)
    : group_(group),
      gram_(instance.gram),
      dual_gram_(group.gram.inverse()),
      size_(size_for(instance.points.size() * group.cosets.size())),
      buckets_(static_cast<std::size_t>(size_ * size_)) {
  for (const Isometry& g : group.cosets)
    for (const Vector& point : instance.points) {
      const Vector image = g * point;
      const Vector x = image + shift_into_cell(group, image);
      const Vector u = Rational(size_) * (group.inverse * x);  // in [0, size)
      buckets_[bucket_of(floor(u[0]).to_long(), floor(u[1]).to_long())].push_back(x);
    }
}

bool OrbitGrid::may_have_point_inside(const Ball& disk, std::size_t& tests) const {
  const Vector centre = disk.centre + shift_into_cell(group_, disk.centre);
  const Vector u = Rational(size_) * (group_.inverse * centre);
  std::array<long, 2> first{}, last{};
  for (int i = 0; i < 2; ++i) {
    // |u_i - c_i| <= |x - c| times the length of the i-th vector of the dual basis (Cauchy and Schwarz).
    const Rational squared = Rational(size_ * size_) * disk.radius_squared * dual_gram_(i, i);
    const double reach = std::floor(std::sqrt(squared.to_double()) * (1 + 1e-9)) + 1;
    if (!(reach < static_cast<double>(size_))) return true;
    const auto k = static_cast<std::size_t>(i);
    first[k] = floor(u[i]).to_long() - static_cast<long>(reach);
    last[k] = floor(u[i]).to_long() + static_cast<long>(reach);
  }
  // Less than three cells of the lattice in each direction.
  for (long column = first[0]; column <= last[0]; ++column)
    for (long row = first[1]; row <= last[1]; ++row) {
      const long home_column = (column + 2 * size_) % size_, home_row = (row + 2 * size_) % size_;
      const auto& bucket = buckets_[bucket_of(home_column, home_row)];
      if (bucket.empty()) continue;
      Vector step(2);
      step[0] = (column - home_column) / size_;
      step[1] = (row - home_row) / size_;
      const Vector from_centre = group_.basis * step - centre;
      tests += bucket.size();
      for (const Vector& x : bucket)
        if (squared_length(gram_, x + from_centre) < disk.radius_squared) return true;
    }
  return false;
}

}  // namespace flatdt::ref::picture
