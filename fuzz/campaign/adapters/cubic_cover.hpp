/// Instances for programs that know the unit square and the unit cube torus only: the torus E^d/L over the
/// manifold, L its translation lattice, with all images of the points in one cell.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "flatdt/ref/instance.hpp"

namespace flatdt::adapters {

using Place = std::array<double, 3>;

/// A vertex of a cell: the image with this number, moved by whole periods.
struct Corner {
  std::size_t image;
  std::array<int, 3> offset;
};

/// A triangulation of the torus with periods `sheets`.
struct TorusCells {
  std::array<int, 3> sheets{1, 1, 1};
  std::vector<std::array<Corner, 4>> cells;
  /// What the peer's own writer wrote, if that was asked for; then the rest is not filled in.
  std::string stream;
};

/// The images of the points of an instance in [0,1)^d, all different.
class CubicCover {
 public:
  /// Errors: Unsupported unless the translation lattice is Z^d in the coordinates of the file, the metric is
  /// a multiple of the identity, and all images have coordinates that are doubles.
  explicit CubicCover(const ref::Instance& instance);
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }
  /// The triangulation file for cells on the torus, or on a cover of it.
  [[nodiscard]] std::string file_of(const TorusCells& cells) const;

 private:
  struct Image {
    std::size_t point;
    ref::Isometry element;  // element * points[point] = place
  };
  int dimension_;
  bool is_torus_;
  std::vector<Place> places_;
  std::vector<Image> images_;
};

}  // namespace flatdt::adapters
