#include "flatdt/ref/scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "flatdt/ref/errors.hpp"
#include "picture_group.hpp"
#include "picture_witness.hpp"

namespace flatdt::ref {
namespace {

using namespace picture;

constexpr double kFar = 1e6;  // lattice units

/// Coordinates in the reduced basis of the lattice to Cartesian ones: they are rounded, then the Cholesky
/// factor of the Gram matrix of the basis is applied.
class Cartesian {
 public:
  explicit Cartesian(const PictureGroup& group) : dimension_(group.dimension()) {
    const auto d = static_cast<std::size_t>(dimension_);
    for (std::size_t j = 0; j < d; ++j) {
      for (std::size_t i = j; i < d; ++i) {
        double sum = group.gram(static_cast<int>(i), static_cast<int>(j)).to_double();
        for (std::size_t k = 0; k < j; ++k) sum -= columns_[i][k] * columns_[j][k];
        columns_[i][j] = i == j ? std::sqrt(sum) : sum / columns_[j][j];
        if (!std::isfinite(columns_[i][j]) || !(columns_[j][j] > 0))
          throw LimitReached("the cell is too large, small or long to be drawn");
      }
    }
  }
  [[nodiscard]] const std::array<Place3, 3>& basis() const { return columns_; }
  /// Nothing if u is too far away to be drawn.
  [[nodiscard]] std::optional<Place3> place(const Vector& u) const {
    Place3 p{};
    for (int i = 0; i < dimension_; ++i) {
      const double ui = u[i].to_double();
      if (!(std::abs(ui) < kFar)) return std::nullopt;
      for (std::size_t k = 0; k < 3; ++k) p[k] += ui * columns_[static_cast<std::size_t>(i)][k];
    }
    return p;
  }

 private:
  int dimension_;
  std::array<Place3, 3> columns_{};  // of the factor: the basis vectors
};

class SceneMaker {
 public:
  SceneMaker(const Instance& instance, const Triangulation& triangulation, const PictureGroup& full)
      : instance_(instance), triangulation_(triangulation), full_(full) {}

  Scene make(const SceneOptions& options) {
    const ShownGroup shown = shown_group(instance_, triangulation_, full_, scene_.notes);
    const Cartesian cartesian(shown.group);
    scene_.dimension = instance_.dimension;
    scene_.title = title_of(triangulation_, full_);
    scene_.lattice = cartesian.basis();
    scene_.has_copies = shown.has_copies;
    if (triangulation_.has_subgroup) add_full_lattice(shown.group, cartesian);
    add_cells(shown, cartesian);
    scene_.is_violated.assign(triangulation_.cells.size(), false);
    for (const Witness& witness : witnesses_of(
             instance_, triangulation_, {false, options.show_two_cycle, options.verdict, options.condition},
             full_, shown, scene_.notes))
      add_witness(witness, shown.group, cartesian);
    return std::move(scene_);
  }

 private:
  void add_full_lattice(const PictureGroup& group, const Cartesian& cartesian) {
    std::array<Place3, 3> vectors{};
    for (int i = 0; i < instance_.dimension; ++i) {
      const auto p = cartesian.place(group.inverse * full_.basis.column(i));
      if (!p) return;
      vectors[static_cast<std::size_t>(i)] = *p;
    }
    scene_.full_lattice = vectors;
  }

  void add_cells(const ShownGroup& shown, const Cartesian& cartesian) {
    const std::size_t images = shown.has_copies ? shown.group.cosets.size() : 1;
    if (triangulation_.cells.size() > kMaxSceneCells / images)
      throw LimitReached("more than " + std::to_string(kMaxSceneCells) +
                         " cells with their images: " + "too many to draw");
    std::size_t too_far = 0;
    for (std::size_t image = 0; image < images; ++image) {
      const Isometry& g = shown.group.cosets[image];
      const Isometry to_lattice{shown.group.inverse * g.linear, shown.group.inverse * g.translation};
      for (std::size_t c = 0; c < triangulation_.cells.size(); ++c) {
        Simplex corners = simplex_of(instance_, triangulation_, c);
        for (Vector& x : corners) x = to_lattice * x;
        Vector shift = barycentre(corners);
        for (int i = 0; i < shift.dimension(); ++i) shift[i] = -Rational(floor(shift[i]));
        for (Vector& u : corners) u = u + shift;
        if (!add_cell(c, image, corners, cartesian)) ++too_far;
      }
    }
    if (too_far > 0) scene_.notes.push_back(std::to_string(too_far) + " cells are too large to be drawn.");
  }

  /// The corners are in lattice coordinates.
  bool add_cell(std::size_t c, std::size_t image, const Simplex& corners, const Cartesian& cartesian) {
    Scene::Cell cell{{}, static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(image)};
    std::vector<Place3> places;
    for (const Vector& u : corners) {
      const auto p = cartesian.place(u);
      if (!p) return false;
      places.push_back(*p);
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [where, is_new] = ids_.emplace(corners[k], static_cast<std::uint32_t>(scene_.places.size()));
      if (is_new) {
        scene_.places.push_back(places[k]);
        scene_.point_at.push_back(triangulation_.cells[c][k].point);
      }
      cell.corners[k] = where->second;
    }
    if (is_negative(corners)) std::swap(cell.corners[corners.size() - 2], cell.corners[corners.size() - 1]);
    scene_.cells.push_back(cell);
    return true;
  }

  /// The factor of Cartesian has a positive determinant, so the lattice's coordinates tell, at every scale.
  [[nodiscard]] static bool is_negative(const Simplex& corners) {
    Matrix edges(static_cast<int>(corners.size()) - 1);
    for (int k = 0; k < edges.dimension(); ++k)
      edges.set_column(k, corners[static_cast<std::size_t>(k) + 1] - corners[0]);
    return edges.determinant() < Rational(0);
  }

  void add_witness(const Witness& witness, const PictureGroup& group, const Cartesian& cartesian) {
    for (const std::uint32_t c : witness.cells) scene_.is_violated[c] = true;
    if (witness.point) add_copies_of_point(*witness.point, group, cartesian);
    if (witness.marks.empty()) return;
    const Vector shift = shift_into_cell(group, barycentre(witness.marks.front().corners));
    bool is_complete = true;
    for (const Mark& mark : witness.marks) {
      Scene::Figure figure{mark.kind, {}};
      for (const Vector& x : mark.corners)
        if (const auto p = cartesian.place(group.inverse * (x + shift))) figure.corners.push_back(*p);
      if (figure.corners.size() == mark.corners.size())
        scene_.figures.push_back(std::move(figure));
      else
        is_complete = false;
    }
    if (witness.ball) {
      const auto centre = cartesian.place(group.inverse * (witness.ball->centre + shift));
      const double radius = std::sqrt(witness.ball->radius_squared.to_double());
      if (centre && std::isfinite(radius))
        scene_.sphere = Scene::Sphere{*centre, radius};
      else
        is_complete = false;
    }
    if (!is_complete)
      scene_.notes.emplace_back("A part of the witness is too far away or too large to be drawn.");
  }
  /// All copies that are drawn, or the point itself if no cell has one.
  void add_copies_of_point(std::uint32_t point, const PictureGroup& group, const Cartesian& cartesian) {
    const std::size_t before = scene_.figures.size();
    for (std::size_t k = 0; k < scene_.places.size(); ++k)
      if (scene_.point_at[k] == point) scene_.figures.push_back({Mark::Kind::point, {scene_.places[k]}});
    const Vector& x = instance_.points[point];
    const auto p = cartesian.place(group.inverse * (x + shift_into_cell(group, x)));
    if (scene_.figures.size() == before && p) scene_.figures.push_back({Mark::Kind::point, {*p}});
  }

  const Instance& instance_;
  const Triangulation& triangulation_;
  const PictureGroup& full_;
  Scene scene_;
  std::map<Vector, std::uint32_t> ids_;  // of places, by lattice coordinates
};

}  // namespace

Scene make_scene(const Instance& instance, const Triangulation& triangulation, const SceneOptions& options) {
  const PictureGroup full(analyse(instance));
  return SceneMaker(instance, triangulation, full).make(options);
}

}  // namespace flatdt::ref
