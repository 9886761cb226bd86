/// What the parts of the SVG writer share: the fundamental domain, placement in the plane, copies, marks.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/refutation.hpp"
#include "flatdt/ref/triangulation_format.hpp"
#include "picture_group.hpp"
#include "svg_text.hpp"

namespace flatdt::ref::picture {

/// A fundamental domain of the group, half open, in coordinates of the reduced lattice basis: of a torus the
/// lattice cell, of a Klein bottle the half of it that the glide reflection glues to itself; the lattice cell
/// if nothing may be copied.
struct Domain {
  explicit Domain(const ShownGroup& shown);
  /// x is inside; lattice coordinates.
  [[nodiscard]] bool contains(const Vector& u) const;
  /// The lattice vector, in instance coordinates, that brings x into the lattice cell at the corner.
  [[nodiscard]] Vector shift_into_cell(const PictureGroup& group, const Vector& x) const;

  /// An element of the group that takes x into the domain.
  [[nodiscard]] Isometry into(const PictureGroup& group, const Vector& x) const;

  Vector corner;
  std::array<Rational, 2> sides;
  bool is_glued;
  std::optional<std::size_t> glide;  // the axis along which the glide reflection moves
};

/// Instance coordinates to the page: the first lattice vector points right, y points down.
class Page {
 public:
  /// The view is the bounding box of the domain with a margin, a part of the lattice cell, on all sides.
  Page(const PictureGroup& group, const Domain& domain);
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

/// The outline of the domain with arrows on its sides: sides with as many arrow heads are glued, heads
/// pointing the same way.
std::string domain_text(const Domain& domain, const Page& page);
/// The cell spanned by the basis of another lattice, at the origin.
std::string lattice_cell_text(const PictureGroup& group, const Page& page);

struct DrawnTriangle {
  std::vector<Place> corners;
  bool in_domain;  // its barycentre is in the fundamental domain
  bool turned;     // image under an element that reverses orientation
};
/// All copies of the triangle that meet the view; nothing if they are too many because it is far too large.
std::vector<DrawnTriangle> copies(const Simplex& triangle, const PictureGroup& group, const Domain& domain,
                                  const Page& page);

struct DrawnPoint {
  Place place;
  std::size_t index;
  bool in_domain;
};
/// All copies in view of the points, each orbit under the least index of its points.
std::vector<DrawnPoint> point_copies(const Instance& instance, const PictureGroup& full,
                                     const PictureGroup& shown, const Domain& domain, const Page& page);

/// The marks and the disk of a witness, laid into the domain. Adds a note if they are too far away or
/// too large.
std::string marks_text(const Witness& witness, const PictureGroup& group, const Domain& domain,
                       const Page& page, std::vector<std::string>& notes);
/// The lines under the picture, and samples of the line styles that occur in it.
struct Caption {
  std::string text;
  double height, width;
};
Caption caption_text(const std::string& title, const std::vector<std::string>& sentences,
                     const Witness* witness, double width, double top);

}  // namespace flatdt::ref::picture
