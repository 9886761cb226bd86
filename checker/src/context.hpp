// What the conditions are evaluated on, once the group and the subgroup are known to be admissible.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "complex.hpp"
#include "faces.hpp"
#include "flatdt/checker/check.hpp"
#include "geometry.hpp"

namespace flatdt::checker {

struct Context {
  const Instance& instance;
  const Triangulation& triangulation;
  const Group& group;
  const Subgroup& subgroup;
  const Orbits& orbits;
  const Complex& complex;
  ElementTable& table;
  Geometry& geometry;
  Verdict& verdict;

  const Faces& faces;
  unsigned jobs;

  std::vector<Sign> orientation = {};  ///< by CellId, of the normalised cells

  void holds(ConditionName name, Witness witness = {}) const {
    verdict[name] = {Status::holds, std::move(witness)};
  }
  void fails(ConditionName name, Witness witness) const {
    verdict[name] = {Status::fails, std::move(witness)};
  }
  [[nodiscard]] bool has(ConditionName name) const { return verdict[name].status == Status::holds; }
};

// Each evaluates the conditions it names, whose premises must have been evaluated, and sets their statuses.
void check_vertices(const Context& context);      // vertices.complete
void check_cells(Context& context);               // cells.nondegenerate, volume.exact; fills orientation
void check_facets(const Context& context);        // facets.paired, facets.opposite
void check_delaunay(const Context& context);      // delaunay.empty
void check_simplices(const Context& context);     // simplices.injective
void check_skeleton(const Context& context);      // skeleton.no-loop, skeleton.no-2-cycle
void check_intersection(const Context& context);  // complex.intersection
void check_links(const Context& context);         // links.spheres
void check_topology(const Context& context);      // topology.connected, topology.euler, topology.orientable
void check_homology(const Context& context);      // topology.homology

/// Fetches the cells of the pair some places after the k-th: they lie apart, and are waited for otherwise.
inline void fetch_ahead(const Context& context, std::size_t k) {
  constexpr std::size_t kAhead = 8;
  if (k + kAhead >= context.faces.pairs.size()) return;
  const FacetPair& pair = context.faces.pairs[k + kAhead];
  __builtin_prefetch(&context.complex.cells[index(pair.first.cell)]);
  __builtin_prefetch(&context.complex.cells[index(pair.second.cell)]);
}

/// The orientation of a cell moved by H until its corner `base` is a base lift.
[[nodiscard]] Sign orientation_in_frame(const Context& context, CellId cell, std::size_t base);

/// The side of a facet on which the apex of an occurrence lies: the orientation of (canonical list of the
/// facet, apex) in the frame of the canonical list. Zero if the cell is degenerate.
[[nodiscard]] Sign side_of(const Context& context, const Occurrence& occurrence);

// Witness texts, in the coordinates of the instance.
[[nodiscard]] std::string lift_text(const Context& context, VertexId v, ElementId offset);  // [g]*i
[[nodiscard]] std::string face_text(const Context& context, const FaceKey& face);  // lifts joined by ;
[[nodiscard]] std::string cell_text(const Context& context, CellId cell);          // points of the file
[[nodiscard]] std::string element_text(const Context& context, ElementId element);
[[nodiscard]] std::string number_text(std::size_t number);
[[nodiscard]] std::string number_text(const Rational& number);
/// The points of a cell of the file.
[[nodiscard]] std::vector<Vec<Rational>> cell_points(const Context& context, CellId cell);
/// Moves the cell of occurrence b to the other side of its facet in the cell a of the file.
[[nodiscard]] ElementId file_gluing(const Context& context, const Occurrence& a, const Occurrence& b);

}  // namespace flatdt::checker
