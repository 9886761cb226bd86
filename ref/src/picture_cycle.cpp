/// A loop or 2-cycle of the quotient. Decided exactly, and from the points of E^d alone: the elements of a
/// wrong triangulation may lie outside the group.
#include <map>

#include "picture_witness.hpp"

namespace flatdt::ref::picture {
namespace {

std::string text(const Vector& x) {
  return "(" + x.to_string() + ")";
}

Witness loop(const Vector& x, const Vector& y) {
  Witness witness;
  witness.sentence =
      "Loop: the ends " + text(x) + " and " + text(y) + " of an edge are one vertex of the quotient.";
  witness.marks = {{Mark::Kind::face, {x, y}}};
  return witness;
}

Witness two_cycle(const Vector& middle, const Vector& end, const Vector& other_end) {
  Witness witness;
  witness.sentence = "2-cycle: the edges from " + text(middle) + " to " + text(end) + " and to " +
                     text(other_end) + " have the same ends in the quotient.";
  witness.marks = {{Mark::Kind::face, {middle, end}}, {Mark::Kind::other_face, {middle, other_end}}};
  return witness;
}

}  // namespace

std::optional<Witness> find_cycle(const Instance& instance, const Triangulation& triangulation,
                                  const PictureGroup& group) {
  // Of an edge between two orbits: its lift from the least point of the one with the lesser least point. The
  // group acts freely, so two edges are one modulo the group iff these lifts are equal.
  std::map<std::pair<Vector, Vector>, Vector> edges;  // least points of both orbits -> far end of the lift
  std::optional<Witness> cycle;
  for (std::size_t c = 0; c < triangulation.cells.size(); ++c) {
    const Simplex cell = simplex_of(instance, triangulation, c);
    for (std::size_t k = 0; k < cell.size(); ++k) {
      for (std::size_t m = k + 1; m < cell.size(); ++m) {
        const Vector &x = cell[k], &y = cell[m];
        if (x == y) continue;
        const Isometry gx = to_least(group, x), gy = to_least(group, y);
        const Vector least_x = gx * x, least_y = gy * y;
        if (least_x == least_y) return loop(x, y);
        const bool from_x = least_x < least_y;
        const Vector far_end = from_x ? gx * y : gy * x;
        const auto key = from_x ? std::make_pair(least_x, least_y) : std::make_pair(least_y, least_x);
        const auto [where, is_new] = edges.emplace(key, far_end);
        if (!is_new && where->second != far_end && !cycle)
          cycle = two_cycle(key.first, where->second, far_end);
      }
    }
  }
  return cycle;
}

}  // namespace flatdt::ref::picture
