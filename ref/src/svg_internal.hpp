/// What the parts of the SVG writer share: placement in the plane, copies, witnesses.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::ref::svg_detail {

struct Place {
  double x, y;
};

using Triangle = std::array<Vector, 3>;

/// A group acting on the plane, with the reduced basis of its lattice (columns, instance coordinates).
struct PlaneGroup {
  explicit PlaneGroup(const GroupAnalysis& analysis)
      : cosets(analysis.cosets),
        basis(analysis.frame.basis),
        inverse(basis.inverse()),
        gram(analysis.frame.gram) {}

  std::vector<Isometry> cosets;
  Matrix basis, inverse, gram;
};

/// Instance coordinates to the page: the first lattice vector points right, y points down.
class Page {
 public:
  /// The view is the bounding box of the lattice cell with a margin on all sides.
  explicit Page(const PlaneGroup& group);
  [[nodiscard]] Place place(const Vector& x) const;
  [[nodiscard]] Place place(double u, double v) const;   // lattice coordinates
  [[nodiscard]] double scale() const { return scale_; }  // page units per unit of length
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  /// Lattice coordinates of the view's bounding box.
  [[nodiscard]] const std::array<double, 2>& low() const { return low_; }
  [[nodiscard]] const std::array<double, 2>& high() const { return high_; }
  /// Does the bounding box of these places meet the view?
  [[nodiscard]] bool is_visible(const std::vector<Place>& places) const;

 private:
  [[nodiscard]] Place plain(double u, double v) const;

  Matrix inverse_;
  std::array<double, 2> first_{}, second_{};  // lattice vectors in an orthonormal basis
  double scale_ = 1, width_ = 0, height_ = 0;
  Place corner_{0, 0};
  std::array<double, 2> low_{}, high_{};
};

/// The vertices of the listed cells.
std::vector<Triangle> triangles_of(const Instance& instance, const Triangulation& triangulation);

struct DrawnTriangle {
  std::array<Place, 3> corners;
  bool in_cell;  // its barycentre is in the fundamental cell
};
/// All copies of the triangle that meet the view; nothing if they are too many because it is far too large.
std::vector<DrawnTriangle> copies(const Triangle& triangle, const PlaneGroup& group, const Page& page);

struct DrawnPoint {
  Place place;
  std::size_t index;
  bool in_cell;
};
/// All copies in view of the points, each orbit under the least index of its points.
std::vector<DrawnPoint> point_copies(const Instance& instance, const PlaneGroup& group,
                                     const PlaneGroup& shown, const Page& page);

/// A loop or a 2-cycle: the path end - middle - other_end, whose ends are one vertex modulo G; of a loop only
/// middle - end, two images of one vertex.
struct Cycle {
  bool loop;
  Vector middle, end, other_end;
};
std::optional<Cycle> find_cycle(const std::vector<Triangle>& triangles, const PlaneGroup& group);

struct Violation {
  std::size_t cell, point;
  Vector centre, inside;
  Rational radius_squared, distance_squared;
};
std::optional<Violation> find_violation(const Instance& instance, const std::vector<Triangle>& triangles,
                                        const PlaneGroup& group);

/// The lattice vector that brings x into the fundamental cell spanned by the basis.
Vector shift_into_cell(const PlaneGroup& group, const Vector& x);
/// The element g of the group for which g x is the least point of the orbit in the fundamental cell.
Isometry to_least(const PlaneGroup& group, const Vector& x);

}  // namespace flatdt::ref::svg_detail
