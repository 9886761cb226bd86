/// A valid triangulation with its instance, in the form that edits start from: vertices as points of E^d,
/// faces modulo the group, neighbours. Invariants: the triangulation is valid (weakly Delaunay, of E^d/H);
/// the edits' arguments rest on it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "crystal_group.hpp"
#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::edits {

/// The lift elements[element] * points[point], of a triangulation file.
using FileVertex = ref::Triangulation::CellVertex;
using FileCell = std::array<FileVertex, 4>;

/// A face modulo H: the lift whose barycentre is the canonical point of its orbit, its vertices sorted. H
/// acts freely, so two faces have one key iff H takes one to the other.
using FaceKey = std::vector<ref::Vector>;

/// An instance and a triangulation that belong together.
struct Case {
  ref::Instance instance;
  ref::Triangulation triangulation;
};

/// The point of E^d of a vertex.
[[nodiscard]] ref::Vector position(const Case& c, FileVertex v);
/// The d+1 points of a cell.
[[nodiscard]] std::vector<ref::Vector> positions(const Case& c, const FileCell& cell);

[[nodiscard]] FaceKey face_key(const CrystalGroup& h, const std::vector<ref::Vector>& vertices,
                               ref::Isometry* mover = nullptr);

class Base {
 public:
  /// Requires: valid. `label` names it in messages.
  Base(Case valid, std::string label);

  [[nodiscard]] const Case& valid() const { return case_; }
  [[nodiscard]] const ref::Instance& instance() const { return case_.instance; }
  [[nodiscard]] const ref::Triangulation& triangulation() const { return case_.triangulation; }
  [[nodiscard]] int dimension() const { return case_.instance.dimension; }
  [[nodiscard]] std::size_t corners() const { return static_cast<std::size_t>(dimension()) + 1; }
  [[nodiscard]] std::size_t cell_count() const { return case_.triangulation.cells.size(); }
  /// G, and H: the group of the space that is triangulated.
  [[nodiscard]] const CrystalGroup& group() const { return group_; }
  [[nodiscard]] const CrystalGroup& subgroup() const { return subgroup_; }
  /// H = G.
  [[nodiscard]] bool on_manifold() const { return !case_.triangulation.has_subgroup; }
  [[nodiscard]] const std::string& label() const { return label_; }
  /// The points of a cell, in the order of its vertices.
  [[nodiscard]] const std::vector<ref::Vector>& cell(std::size_t c) const { return cells_[c]; }
  /// Points of the instance, no two of them in one orbit.
  [[nodiscard]] bool points_are_distinct() const { return points_are_distinct_; }

  /// The neighbour across the facet opposite to a corner: `to` takes it to where it shares that facet.
  struct Neighbour {
    std::size_t cell;
    std::size_t corner;  ///< of the neighbour, opposite to the shared facet
    ref::Isometry to;
  };
  [[nodiscard]] const Neighbour& neighbour(std::size_t cell, std::size_t corner) const {
    return neighbours_[cell][corner];
  }
  /// The apex of the neighbour across the facet opposite to `corner`, moved there.
  [[nodiscard]] ref::Vector apex_across(std::size_t cell, std::size_t corner) const;

  /// (cell, corner): the apex across the facet opposite to the corner is on the sphere of the cell.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& ties() const;

  /// Would an edge between two points that are not joined be a loop or make a 2-cycle modulo H?
  [[nodiscard]] bool closes_short_cycle(const ref::Vector& u, const ref::Vector& v) const;

 private:
  Case case_;
  std::string label_;
  CrystalGroup group_;
  CrystalGroup subgroup_;
  std::vector<std::vector<ref::Vector>> cells_;
  std::vector<std::vector<Neighbour>> neighbours_;
  bool points_are_distinct_ = true;
  mutable std::optional<std::vector<std::pair<std::size_t, std::size_t>>> ties_;
  mutable std::optional<std::set<std::pair<ref::Vector, ref::Vector>>>
      joined_;  // canonical ends of the edges
};

/// The occurrences of every facet modulo H are two each. Cells that repeat a point count as unpaired.
[[nodiscard]] bool facets_are_paired(const Case& c, const CrystalGroup& h);

}  // namespace flatdt::edits
