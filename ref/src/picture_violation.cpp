/// A disk with a point inside, found by ref itself. Decided exactly, and from the points in the plane alone:
/// the elements of a wrong triangulation may lie outside the group.
#include "flatdt/ref/errors.hpp"
#include "orbit_grid.hpp"
#include "picture_witness.hpp"

namespace flatdt::ref::picture {
namespace {

/// Distances computed exactly: some ten seconds.
constexpr std::size_t kMaxTests = std::size_t{1} << 22;

struct Violation {
  std::size_t point;
  Vector inside;
  Rational distance_squared;
};

Witness witness_of_violation(std::size_t cell, const Simplex& corners, const Ball& disk,
                             const Violation& found) {
  Witness witness;
  witness.sentence = "Violation: the circumdisk of cell " + std::to_string(cell) + " has point " +
                     std::to_string(found.point) + " inside, at (" + found.inside.to_string() +
                     "): squared distance from the centre " + found.distance_squared.to_string() +
                     " < squared radius " + disk.radius_squared.to_string() + ".";
  witness.marks = {{Mark::Kind::cell, corners}, {Mark::Kind::point, {found.inside}}};
  witness.ball = disk;
  return witness;
}

std::optional<Violation> deepest_inside(const Instance& instance, const PictureGroup& group,
                                        const Ball& disk) {
  std::optional<Violation> deepest;
  for (std::size_t i = 0; i < instance.points.size(); ++i) {
    for (const Isometry& g : group.cosets) {
      // The nearest image of a point is at a corner of the cell that holds the centre: the basis is reduced.
      const Vector image = g * instance.points[i];
      const Vector near = image - shift_into_cell(group, disk.centre - image);
      for (int corner = 0; corner < 4; ++corner) {
        Vector step(2);
        step[0] = corner % 2;
        step[1] = corner / 2;
        const Vector x = near + group.basis * step;
        const Rational distance_squared = squared_length(instance.gram, x - disk.centre);
        if (distance_squared >= disk.radius_squared) continue;
        if (deepest && distance_squared >= deepest->distance_squared) continue;
        deepest = Violation{i, x, distance_squared};
      }
    }
  }
  return deepest;
}

}  // namespace

std::optional<Witness> find_violation(const Instance& instance, const Triangulation& triangulation,
                                      const PictureGroup& group) {
  const OrbitGrid grid(instance, group);
  std::size_t tests = 0;
  for (std::size_t k = 0; k < triangulation.cells.size(); ++k) {
    const Simplex corners = simplex_of(instance, triangulation, k);
    const std::optional<Ball> disk = circumscribed_ball(instance.gram, corners);
    if (!disk) continue;
    const bool may_have = grid.may_have_point_inside(*disk, tests);
    if (may_have) tests += 4 * instance.points.size() * group.cosets.size();
    if (tests > kMaxTests)
      throw LimitReached("the circumdisks up to that of cell " + std::to_string(k) + " take more than " +
                         std::to_string(kMaxTests) +
                         " exact distances to search: draw without --violation, or with "
                         "the verdict of flatdt-check");
    if (!may_have) continue;
    const std::optional<Violation> deepest = deepest_inside(instance, group, *disk);
    if (deepest) return witness_of_violation(k, corners, *disk, *deepest);
  }
  return std::nullopt;
}

}  // namespace flatdt::ref::picture
