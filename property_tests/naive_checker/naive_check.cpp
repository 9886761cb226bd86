#include "naive_checker/naive_check.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "naive_checker/definitions.hpp"
#include "naive_checker/face_complex.hpp"
#include "naive_checker/group_facts.hpp"
#include "naive_checker/topology.hpp"
#include "oracle/group.hpp"

namespace flatdt::naive {
namespace {

using checker::ConditionName;
using checker::Outcome;
using checker::Status;
using oracle::circumscribed_ball;
using oracle::determinant;
using oracle::edges_from_first;
using oracle::generated_group;
using oracle::Group;
using oracle::image;
using oracle::minus;
using oracle::Rational;
using oracle::simplex_volume;
using oracle::square;
using oracle::Vector;

/// [G:H] times the number of points up to which the definitions are decided.
constexpr long kMaxVertices = 100'000;

void set(Report& report, ConditionName name, bool good) {
  report.status[static_cast<std::size_t>(name)] = good ? Status::holds : Status::fails;
}

bool hold(const Report& report, std::initializer_list<ConditionName> names) {
  return std::all_of(names.begin(), names.end(), [&](ConditionName n) { return report[n] == Status::holds; });
}

/// group.*: the group, if it is admissible.
std::optional<Group> judge_group(const checker::Instance& instance, Report& report) {
  std::optional<Group> group = generated_group(instance.dimension, instance.generators, instance.metric);
  set(report, ConditionName::group_crystallographic, group.has_value());
  if (!group) return std::nullopt;
  const bool is_free = is_torsion_free(*group);
  set(report, ConditionName::group_torsion_free, is_free);
  if (!is_free) return std::nullopt;
  if (instance.claim) {
    const bool is_right = manifold_name(*group) == *instance.claim;
    set(report, ConditionName::group_name, is_right);
    if (!is_right) return std::nullopt;
  }
  return group;
}

/// subgroup.member: H, if it is a subgroup of finite index and all elements are in G.
std::optional<Group> judge_subgroup(const checker::Instance& instance, const Group& group,
                                    const checker::Triangulation& triangulation, Report& report) {
  bool inside = true;
  for (std::size_t k = 0; k < triangulation.elements.size(); ++k)
    inside = inside && group.contains(triangulation.element(k));
  std::optional<Group> subgroup = group;
  if (triangulation.subgroup) {
    for (const checker::Seitz& g : *triangulation.subgroup) inside = inside && group.contains(g);
    if (inside) subgroup = generated_group(instance.dimension, *triangulation.subgroup, instance.metric);
  }
  const bool good = inside && subgroup.has_value();
  set(report, ConditionName::subgroup_member, good);
  return good ? subgroup : std::nullopt;
}

std::vector<std::vector<Vector>> lifted(const checker::Instance& instance,
                                        const checker::Triangulation& triangulation) {
  std::vector<std::vector<Vector>> cells;
  for (const checker::FileCell& cell : triangulation.cells) {
    std::vector<Vector> corners;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(instance.dimension); ++j)
      corners.push_back(image(triangulation.element(cell[j].element), instance.points[cell[j].point]));
    cells.push_back(std::move(corners));
  }
  return cells;
}

std::size_t number_of_orbits(const Group& group, const std::vector<Vector>& points) {
  std::set<Vector> orbits;
  for (const Vector& p : points) orbits.insert(group.canonical(p).first);
  return orbits.size();
}

/// facets.opposite, and whether an apex lies strictly inside the ball of the cell across a facet.
struct AcrossFacets {
  bool opposite = true;
  bool empty = true;
};

AcrossFacets across_facets(const FaceComplex& complex, const oracle::Matrix& metric) {
  AcrossFacets result;
  const int d = complex.dimension;
  for (const auto& [facet, occurrences] : complex.facets()) {
    if (occurrences.size() != 2) continue;
    std::vector<std::vector<Vector>> sides;  // the facet and the apex, of both cells, in one place
    for (const Occurrence& o : occurrences) {
      sides.push_back(facet);
      sides.back().push_back(image(o.mover, complex.cells[o.cell][FaceComplex::apex(o)]));
    }
    const int first = sgn(determinant(edges_from_first(sides[0]), d));
    const int second = sgn(determinant(edges_from_first(sides[1]), d));
    if (first == 0 || second == 0) continue;
    if (first == second) {
      result.opposite = false;
      continue;
    }
    for (const std::size_t k : {0U, 1U}) {
      const oracle::Ball ball = circumscribed_ball(sides[k], metric, d);
      const Vector away = minus(sides[1 - k].back(), ball.centre);
      if (square(metric, away) < ball.squared_radius) result.empty = false;
    }
  }
  return result;
}

/// The ends of an edge: the canonical points of their orbits, in order.
std::pair<Vector, Vector> ends_of(const Face& edge, const Group& subgroup) {
  const Vector a = subgroup.canonical(edge[0]).first;
  const Vector b = subgroup.canonical(edge[1]).first;
  return std::minmax(a, b);
}

/// vertices, cells, facets, volume, delaunay.
void judge_tiling(const FaceComplex& complex, const Group& group, const checker::Instance& instance,
                  Report& report) {
  using enum ConditionName;
  const Rational sheets = complex.subgroup.covolume() / group.covolume();
  set(report, vertices_complete,
      Rational(complex.faces[0].size()) >= sheets * Rational(number_of_orbits(group, instance.points)));
  Rational sum = 0;
  bool flat = false;
  for (const std::vector<Vector>& cell : complex.cells) {
    const Rational volume = simplex_volume(cell, complex.dimension);
    sum += volume;
    flat = flat || volume == 0;
  }
  set(report, cells_nondegenerate, !flat);
  // A cell with one point as two corners has no facets in the sense of the pairing.
  set(report, facets_paired,
      !complex.has_repeated_vertex &&
          std::all_of(complex.facets().begin(), complex.facets().end(),
                      [](const auto& facet) { return facet.second.size() == 2; }));
  const AcrossFacets across = across_facets(complex, instance.metric);
  set(report, facets_opposite, across.opposite);
  set(report, volume_exact, sum == complex.subgroup.covolume());
  if (!across.empty) {
    set(report, delaunay_empty, false);
  } else if (hold(report,
                  {vertices_complete, cells_nondegenerate, facets_paired, facets_opposite, volume_exact})) {
    set(report, delaunay_empty, balls_are_empty(complex, group, instance));
    if (report[delaunay_empty] == Status::fails)
      report.contradictions.emplace_back("a tiling is locally but not globally Delaunay");
  }
}

/// simplices, skeleton, complex.
void judge_complex(const FaceComplex& complex, Report& report) {
  using enum ConditionName;
  bool injective = true;
  for (const std::vector<Vector>& cell : complex.cells) {
    const std::set<Vector> corners(cell.begin(), cell.end());
    std::set<Vector> orbits;
    for (const Vector& x : corners) orbits.insert(complex.subgroup.canonical(x).first);
    injective = injective && orbits.size() == corners.size();
  }
  set(report, simplices_injective, injective);
  bool loop = false;
  bool double_edge = false;
  std::set<std::pair<Vector, Vector>> joined;
  for (const auto& [edge, occurrences] : complex.faces[1]) {
    const auto ends = ends_of(edge, complex.subgroup);
    loop = loop || ends.first == ends.second;
    double_edge = double_edge || !joined.insert(ends).second;
  }
  set(report, skeleton_no_loop, !loop);
  set(report, skeleton_no_2_cycle, !double_edge);
  if (!hold(report, {cells_nondegenerate, facets_paired, facets_opposite, volume_exact})) return;
  bool different = true;
  std::set<std::set<Vector>> vertex_sets;
  for (const auto& faces : complex.faces) {
    for (const auto& [face, occurrences] : faces) {
      std::set<Vector> orbits;
      for (const Vector& x : face) orbits.insert(complex.subgroup.canonical(x).first);
      different = vertex_sets.insert(std::move(orbits)).second && different;
    }
  }
  set(report, complex_intersection, different && injective);
}

/// links, topology.
void judge_topology(const FaceComplex& complex, Report& report) {
  using enum ConditionName;
  if (!hold(report, {facets_paired})) return;
  if (hold(report, {cells_nondegenerate})) set(report, links_spheres, links_are_spheres(complex));
  set(report, topology_connected, is_connected(complex));
  set(report, topology_euler, euler_number(complex) == 0);
  set(report, topology_orientable, is_orientable(complex) == complex.subgroup.is_orientable());
  set(report, topology_homology, first_homology(complex) == first_homology(complex.subgroup));
}

void judge_definitions(const FaceComplex& complex, const Group& group, const checker::Instance& instance,
                       Report& report) {
  using enum ConditionName;
  const Rational sheets = complex.subgroup.covolume() / group.covolume();
  if (sheets * Rational(instance.points.size()) > kMaxVertices) return;
  Definitions found;
  const bool solid = report[cells_nondegenerate] == Status::holds;
  if (solid) {
    const Intersections meet = intersections(complex);
    // Simplices with disjoint interiors cover E^d/H iff their volumes add up to its volume.
    found.tiling = meet.face_to_face && report[volume_exact] == Status::holds;
    found.complex = found.tiling && meet.at_most_once;
  }
  found.vertices = has_all_vertices(complex, group, instance);
  found.delaunay = solid && balls_are_empty(complex, group, instance);
  report.definitions = found;
}

/// What docs/soundness.md proves about the computed facts.
void compare_with_theorems(Report& report) {
  using enum ConditionName;
  const auto claim = [&](bool holds, const char* theorem) {
    if (!holds) report.contradictions.emplace_back(theorem);
  };
  const bool tiles = hold(report, {cells_nondegenerate, facets_paired, facets_opposite, volume_exact});
  if (tiles) {
    claim((report[simplices_injective] == Status::holds) == (report[skeleton_no_loop] == Status::holds),
          "in a tiling: injective iff no loop");
    claim((report[complex_intersection] == Status::holds) ==
              hold(report, {skeleton_no_loop, skeleton_no_2_cycle}),
          "Theorem 7 and its converse");
    claim(hold(report,
               {links_spheres, topology_connected, topology_euler, topology_orientable, topology_homology}),
          "in a tiling: links are spheres, and the topology is that of E^d/H");
  }
  if (!report.definitions) return;
  const Definitions& d = *report.definitions;
  claim(d.tiling == tiles, "Proposition 1: nondegenerate, paired, opposite, exact volume iff a tiling");
  claim(d.vertices == (report[vertices_complete] == Status::holds),
        "as many vertices as GP has modulo H iff all");
  if (d.tiling) {
    claim(d.complex == (report[complex_intersection] == Status::holds),
          "Definition 1 (ii) iff complex.intersection");
    if (d.vertices) claim(d.delaunay == (report[delaunay_empty] == Status::holds), "Proposition 2");
  }
  claim(d.all() == (report.outcome == Outcome::verified), "verified iff a Delaunay triangulation of E^d/H");
}

}  // namespace

Report naive_check(const checker::Instance& instance, const checker::Triangulation& triangulation,
                   Depth depth) {
  Report report;
  report.status.fill(Status::skipped);
  report.outcome = Outcome::malformed;
  const std::optional<Group> group = judge_group(instance, report);
  if (!group) return report;
  report.outcome = Outcome::refuted;
  const std::optional<Group> subgroup = judge_subgroup(instance, *group, triangulation, report);
  if (!subgroup) return report;

  const FaceComplex complex = face_complex(instance.dimension, *subgroup, lifted(instance, triangulation));
  judge_tiling(complex, *group, instance, report);
  judge_complex(complex, report);
  judge_topology(complex, report);
  if (std::find(report.status.begin(), report.status.end(), Status::fails) == report.status.end())
    report.outcome = Outcome::verified;
  if (depth == Depth::definitions) judge_definitions(complex, *group, instance, report);
  compare_with_theorems(report);
  return report;
}

std::string disagreement(const Report& naive, const checker::Verdict& verdict) {
  std::string text;
  for (std::size_t k = 0; k < checker::kConditionCount; ++k) {
    const auto name = static_cast<ConditionName>(k);
    const Status said = verdict[name].status;
    if (said == naive[name]) continue;
    text += std::string(to_string(name)) + ": naive " + std::string(to_string(naive[name])) + ", checker " +
            std::string(to_string(said)) + "\n";
  }
  if (naive.outcome != verdict.outcome)
    text += "outcome: naive " + std::string(to_string(naive.outcome)) + ", checker " +
            std::string(to_string(verdict.outcome)) + " " + verdict.reason + "\n";
  for (const std::string& theorem : naive.contradictions) text += "contradiction: " + theorem + "\n";
  return text;
}

}  // namespace flatdt::naive
