#include "oracle/compare.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/group.hpp"
#include "oracle/hull.hpp"
#include "oracle/polytope.hpp"

namespace flatdt::oracle {
namespace {

/// The cells of a triangulation whose circumcentres are one point modulo H, moved by H to have it as
/// circumcentre.
struct Filling {
  const DelaunayCell* cell;
  Seitz to_cell;  // of G, takes that point to the centre of the cell
  std::vector<std::vector<Vector>> simplices;
};

std::vector<Vector> corners_of(const checker::Instance& instance, const checker::Triangulation& triangulation,
                               std::size_t k) {
  std::vector<Vector> corners;
  for (std::size_t j = 0; j <= static_cast<std::size_t>(instance.dimension); ++j) {
    const checker::FileVertex& v = triangulation.cells[k][j];
    corners.push_back(image(triangulation.element(v.element), instance.points[v.point]));
  }
  return corners;
}

/// All corners, moved by g, are among the points of the cell.
bool lies_in(const DelaunayCell& cell, const std::vector<Vector>& corners, const Seitz& g) {
  return std::all_of(corners.begin(), corners.end(), [&](const Vector& x) {
    const Vector y = image(g, x);
    return std::any_of(cell.points.begin(), cell.points.end(),
                       [&](const OrbitPoint& p) { return p.position == y; });
  });
}

/// The volume of the hull of the points of a cell.
Rational volume_of(const DelaunayCell& cell, int dimension) {
  std::vector<Vector> points;
  for (const OrbitPoint& p : cell.points) points.push_back(p.position);
  return hull_volume(points, dimension);
}

/// What is wrong with the simplices that should fill a cell of volume `whole`; empty if nothing is.
std::string flaw(const Filling& filling, const Rational& whole, int dimension) {
  Rational volume = 0;
  for (const std::vector<Vector>& s : filling.simplices) volume += simplex_volume(s, dimension);
  if (volume != whole) return "cells of volume " + volume.get_str() + " instead of " + whole.get_str();
  for (std::size_t i = 0; i < filling.simplices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (intersection(Polytope::simplex(filling.simplices[i], dimension),
                       Polytope::simplex(filling.simplices[j], dimension))
              .has_interior())
        return "two cells that overlap";
  return "";
}

}  // namespace

std::string difference(const checker::Instance& instance, const Tessellation& tessellation,
                       const checker::Triangulation& triangulation) {
  const int d = instance.dimension;
  const std::optional<Group> group = generated_group(d, instance.generators, instance.metric);
  if (!group) return "the group is not crystallographic";
  std::optional<Group> subgroup = group;
  if (triangulation.subgroup) {
    for (const Seitz& g : *triangulation.subgroup)
      if (!group->contains(g)) return "a generator of the subgroup is not in the group";
    subgroup = generated_group(d, *triangulation.subgroup, instance.metric);
    if (!subgroup) return "the subgroup has infinite index";
  }
  std::map<Vector, const DelaunayCell*> by_centre;
  for (const DelaunayCell& cell : tessellation.cells) by_centre[cell.centre] = &cell;

  std::map<Vector, Filling> fillings;  // by the canonical centre modulo H
  for (std::size_t k = 0; k < triangulation.cells.size(); ++k) {
    const std::string name = "cell " + std::to_string(k);
    std::vector<Vector> corners = corners_of(instance, triangulation, k);
    if (simplex_volume(corners, d) == 0) return name + " is flat";
    const Ball ball = circumscribed_ball(corners, instance.metric, d);
    const auto [place, in_subgroup] = subgroup->canonical(ball.centre);
    auto at = fillings.find(place);
    if (at == fillings.end()) {
      const auto [centre, to_cell] = group->canonical(place);
      const auto found = by_centre.find(centre);
      if (found == by_centre.end())
        return name + " has its circumcentre at " + to_text(ball.centre, d) + ", which is no Voronoi vertex";
      at = fillings.emplace(place, Filling{found->second, to_cell, {}}).first;
    }
    Filling& filling = at->second;
    if (filling.cell->squared_radius != ball.squared_radius)
      return name + " has squared circumradius " + ball.squared_radius.get_str() + " instead of " +
             filling.cell->squared_radius.get_str();
    for (Vector& x : corners) x = image(in_subgroup, x);
    if (!lies_in(*filling.cell, corners, filling.to_cell))
      return name + " has a vertex that is none of the points around the Voronoi vertex " +
             to_text(ball.centre, d);
    filling.simplices.push_back(std::move(corners));
  }

  std::map<Vector, Rational> volumes;    // of the cells of the tessellation, by centre
  std::map<Vector, std::size_t> sheets;  // of E^d/H on which they are filled
  for (const DelaunayCell& cell : tessellation.cells) volumes[cell.centre] = volume_of(cell, d);
  for (const auto& [place, filling] : fillings) {
    const std::string wrong = flaw(filling, volumes.at(filling.cell->centre), d);
    if (!wrong.empty()) return "at the Voronoi vertex " + to_text(place, d) + ": " + wrong;
    ++sheets[filling.cell->centre];
  }
  const Rational index = subgroup->covolume() / group->covolume();
  for (const DelaunayCell& cell : tessellation.cells)
    if (sheets[cell.centre] != index)
      return "the Voronoi vertex " + to_text(cell.centre, d) + " has cells over it on " +
             std::to_string(sheets[cell.centre]) + " of " + index.get_str() + " sheets";
  return "";
}

}  // namespace flatdt::oracle
