/// The orbits of the points of an instance in the plane, in a grid of buckets over the lattice's cell:
/// whether a disk has one of them strictly inside, exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/refutation.hpp"
#include "picture_group.hpp"

namespace flatdt::ref::picture {

class OrbitGrid {
 public:
  /// Requires: dimension 2. Complexity: O(points x cosets).
  OrbitGrid(const Instance& instance, const PictureGroup& group);

  /// Whether a point of the orbits may be strictly inside the disk. False is certain. True is certain but for
  /// disks that reach as far as the lattice's cell, which are not looked into. Adds the distances computed
  /// to `tests`. Complexity: the points in the buckets that the disk's bounding box meets, at most four times
  /// all.
  [[nodiscard]] bool may_have_point_inside(const Ball& disk, std::size_t& tests) const;

 private:
  [[nodiscard]] std::size_t bucket_of(long column, long row) const {
    return static_cast<std::size_t>(column * size_ + row);
  }

  PictureGroup group_;
  Matrix gram_, dual_gram_;  // of the instance's coordinates; the inverse of that of the lattice's basis
  long size_;                // buckets in each direction
  std::vector<std::vector<Vector>> buckets_;  // instance coordinates, in the lattice's cell
};

}  // namespace flatdt::ref::picture
