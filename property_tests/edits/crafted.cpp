#include "crafted.hpp"

#include <stdexcept>
#include <string>

#include "flatdt/ref/families.hpp"
#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"
#include "respace.hpp"

namespace flatdt::edits {

using ref::Isometry;

namespace {

/// One point to a unit square, so that every square is a tie.
constexpr std::string_view kSquares = "flatdt-instance 1\ndimension 2\nmanifold torus\npoints 1\n 0 0\n";
/// One point to a unit cube.
constexpr std::string_view kCubes = "flatdt-instance 1\ndimension 3\nmanifold torocosm\npoints 1\n 0 0 0\n";
/// A double pyramid over a triangle, on a sphere of radius 2/5 about the origin that holds no other point.
/// ref cuts it into three cells about its axis,
constexpr std::string_view kThreeAboutAnEdge =
    "flatdt-instance 1\ndimension 3\nmanifold torocosm\npoints 5\n"
    " 0 0 2/5\n 0 0 -2/5\n 2/5 0 0\n -6/25 8/25 0\n -6/25 -8/25 0\n";
/// and with the axis in another direction, where a corner of the triangle has the largest rank, into two.
constexpr std::string_view kTwoOnATriangle =
    "flatdt-instance 1\ndimension 3\nmanifold torocosm\npoints 5\n"
    " 2/5 0 0\n -2/5 0 0\n 0 2/5 0\n 0 -6/25 8/25\n 0 -6/25 -8/25\n";
/// One orbit of a 4-fold screw axis, off it.
constexpr std::string_view kScrew =
    "flatdt-instance 1\ndimension 3\nmanifold tetracosm\npoints 1\n 4/15 1/4 0\n";
/// Rows of points of distance 1, alternately shifted by 1/5 and -1/5: no ties.
constexpr std::string_view kRows =
    "flatdt-instance 1\ndimension 2\nmanifold klein-bottle\npoints 1\n 1/5 0\n";

Isometry translation(const std::vector<int>& by) {
  ref::Vector v(static_cast<int>(by.size()));
  for (int k = 0; k < v.dimension(); ++k) v[k] = ref::Rational(by[static_cast<std::size_t>(k)]);
  return Isometry::translate(v);
}

/// Of the Klein bottle: (-x, y + half_turns / 2).
Isometry glide(int half_turns) {
  Isometry g = Isometry::identity(2);
  g.linear(0, 0) = ref::Rational(-1);
  g.translation[1] = ref::Rational(ref::Integer(half_turns), ref::Integer(2));
  return g;
}

Case triangulated(ref::Instance instance) {
  Case made;
  made.instance = std::move(instance);
  made.triangulation = ref::triangulate(made.instance, ref::analyse(made.instance), {}).triangulation;
  return made;
}

Case over(std::string_view instance, const std::vector<Isometry>& subgroup, const std::string& label) {
  std::optional<Case> small = over_subgroup(triangulated(ref::parse_instance(instance, label)), subgroup);
  if (!small) throw std::logic_error(label + ": not simplicial");
  return std::move(*small);
}

Case generated(std::string_view manifold, std::string_view family, long points) {
  return triangulated(ref::generate(*ref::find_entry(manifold), manifold, family, points, 1));
}

}  // namespace

std::vector<Crafted> crafted_bases() {
  using Names = std::vector<std::string_view>;
  std::vector<Crafted> all;
  const auto add = [&](const Case& cover, const std::string& label, const Names& in_cover,
                       const Names& on_manifold) {
    all.push_back({Base(cover, label), in_cover});
    all.push_back({Base(as_manifold(cover), label + " as a manifold"), on_manifold});
  };
  // The six differences of ends of edges are different modulo the lattice, and with 0 all there are: every
  // two of the seven points are joined.
  const std::string seven = "squares, seven points";
  add(over(kSquares, {translation({2, 1}), translation({1, -3})}, seven), seven,
      {"tie flipped, making a short cycle"}, {"tie flipped, making a short cycle"});
  // The same in space: fourteen differences, fifteen points.
  const std::string fifteen = "cubes, fifteen points";
  add(over(kCubes, {translation({1, 1, 1}), translation({0, 3, 4}), translation({0, 0, 5})}, fifteen),
      fifteen, {"tie flipped, making a short cycle"}, {"tie flipped, making a short cycle"});
  const std::string sixteen = "squares, sixteen points";
  add(over(kSquares, {translation({4, 0}), translation({0, 4})}, sixteen), sixteen,
      {"tie flipped in one sheet, 2-2"}, {"tie flipped 2-2"});
  // The least index at which both are simplicial.
  const std::vector<Isometry> nine = {translation({1, 0, 2}), translation({0, 1, 4}), translation({0, 0, 9})};
  const std::string three_cells = "double pyramid of three cells";
  add(over(kThreeAboutAnEdge, nine, three_cells), three_cells,
      {"tie flipped in one sheet, 3-2", "tie flipped in one sheet, 4-4"},
      {"tie flipped 3-2", "tie flipped 4-4", "flip 3-2", "flip 4-4",
       "cell split at a new point in no other ball"});
  const std::string two_cells = "double pyramid of two cells";
  add(over(kTwoOnATriangle, nine, two_cells), two_cells, {"tie flipped in one sheet, 2-3"},
      {"tie flipped 2-3", "flip 2-3", "point moved through a facet",
       "flat cell between two cuts of a quadrilateral"});
  const std::string klein = "nine points of a Klein bottle";
  add(over(kRows, {glide(3), translation({3, 0})}, klein), klein,
      {"unfolded to a subgroup with holonomy", "metric not invariant"},
      {"unfolded to a subgroup with holonomy", "point moved through a facet"});
  const std::string screw = "orbit of a screw axis";
  Random random(1, screw);
  const std::optional<Case> small =
      over_small_subgroup(triangulated(ref::parse_instance(kScrew, screw)), random);
  if (!small) throw std::logic_error(screw + ": no small subgroup");
  all.push_back({Base(*small, screw), {"group of the other hand"}});
  all.push_back({Base(generated("torocosm", "grid", 27), "cubes, twenty-seven points"),
                 {"checkerboard: a connected double cover claimed as the torus",
                  "torus glued into a manifold that it covers"}});
  all.push_back({Base(generated("torus", "uniform", 20), "twenty random points"),
                 {"cell split at a new point in no other ball", "point moved through a facet"}});
  return all;
}

}  // namespace flatdt::edits
