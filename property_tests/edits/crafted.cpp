#include "crafted.hpp"

#include <array>
#include <stdexcept>
#include <string>

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

Case over(std::string_view instance, const std::vector<Isometry>& subgroup, const std::string& label) {
  Case made;
  made.instance = ref::parse_instance(instance, label);
  made.triangulation = ref::triangulate(made.instance, ref::analyse(made.instance), {}).triangulation;
  std::optional<Case> small = over_subgroup(made, subgroup);
  if (!small) throw std::logic_error(label + ": not simplicial");
  return std::move(*small);
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
  add(over(kSquares, {translation({2, 1}), translation({1, -3})}, "squares, seven points"),
      "squares, seven points", {"tie flipped, making a short cycle"}, {"tie flipped, making a short cycle"});
  // The same in space: fourteen differences, fifteen points.
  add(over(kCubes, {translation({1, 1, 1}), translation({0, 3, 4}), translation({0, 0, 5})},
           "cubes, fifteen points"),
      "cubes, fifteen points", {"tie flipped, making a short cycle"}, {"tie flipped, making a short cycle"});
  // The least index at which both are simplicial.
  const std::vector<Isometry> nine = {translation({1, 0, 2}), translation({0, 1, 4}), translation({0, 0, 9})};
  add(over(kThreeAboutAnEdge, nine, "double pyramid of three cells"), "double pyramid of three cells",
      {"tie flipped in one sheet, 3-2"}, {"tie flipped 3-2", "flip 3-2"});
  add(over(kTwoOnATriangle, nine, "double pyramid of two cells"), "double pyramid of two cells",
      {"tie flipped in one sheet, 2-3"}, {"tie flipped 2-3"});
  add(over(kRows, {glide(3), translation({3, 0})}, "nine points of a Klein bottle"),
      "nine points of a Klein bottle", {"unfolded to a subgroup with holonomy"},
      {"unfolded to a subgroup with holonomy"});
  return all;
}

}  // namespace flatdt::edits
