/// The quotient complex: cells of a periodic triangulation of E^d modulo a subgroup H.
/// Role: the one data structure that covers, quotients and intermediate states live in. It need not be
/// simplicial: a vertex may occur twice in a cell, two cells may have the same vertices, a cell may neighbour
/// itself. That is why traversals go over pairs (cell, element), never over bare cell ids. Invariants: the
/// base lift of a cell, { offset[k] * vertex[k] }, is positively oriented; facet k is opposite vertex k;
/// gluing[k] * (base lift of neighbour[k]) shares facet k with the base lift of the cell.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flatdt/ref/canonical_face.hpp"
#include "flatdt/ref/element_store.hpp"
#include "flatdt/ref/predicates.hpp"

namespace flatdt::ref {

enum class CellId : std::uint32_t {};
enum class VertexId : std::uint32_t {};
constexpr std::uint32_t index_of(CellId id) {
  return static_cast<std::uint32_t>(id);
}
constexpr std::uint32_t index_of(VertexId id) {
  return static_cast<std::uint32_t>(id);
}
inline constexpr CellId kNoCell{0xffffffffU};
inline constexpr VertexId kNoVertex{0xffffffffU};

/// The d+1 points of GP of one lift of a cell.
template <int D>
using CellPoints = std::array<OrbitPoint, D + 1>;

template <int D>
class QuotientComplex {
 public:
  struct Vertex {
    std::array<double, 3> x{};  // of base * site
    OrbitPoint point;           // site and base = representative of the coset H g
    CellId cell = kNoCell;      // some cell with this vertex
  };
  /// 52 bytes in space. Elements as codes of the complex's store: see offset() and gluing().
  struct Cell {
    std::array<VertexId, D + 1> vertex;  // kNoVertex first: the slot is free
    std::array<CellId, D + 1> neighbour;
    std::array<ElementStore::Code, D + 1> offset;  // in H
    std::array<ElementStore::Code, D + 1> gluing;  // in H
    /// Where a search has noted its latest visit; means something only if that note names this cell.
    std::uint32_t visit = 0;

    [[nodiscard]] bool is_alive() const { return vertex[0] != kNoVertex; }
  };

  QuotientComplex(const GroupTable& table, const std::vector<Site>& sites, Subgroup subgroup)
      : table_(&table), sites_(&sites), subgroup_(std::move(subgroup)), first_vertex_(sites.size(), kNone) {}

  [[nodiscard]] const GroupTable& table() const { return *table_; }
  [[nodiscard]] const Subgroup& subgroup() const { return subgroup_; }

  /// Adds the [G:H] vertices of a site, without cells. The vertex of coset `rep` has id first + rep.
  void add_site(SiteId site);
  [[nodiscard]] bool has_site(SiteId site) const { return first_vertex_[index_of(site)] != kNone; }
  [[nodiscard]] VertexId vertex_of(SiteId site, std::uint32_t rep) const {
    return VertexId{first_vertex_[index_of(site)] + rep};
  }
  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }
  [[nodiscard]] Vertex& vertex(VertexId v) { return vertices_[index_of(v)]; }
  [[nodiscard]] const Vertex& vertex(VertexId v) const { return vertices_[index_of(v)]; }

  [[nodiscard]] Cell& cell(CellId c) { return cells_[index_of(c)]; }
  [[nodiscard]] const Cell& cell(CellId c) const { return cells_[index_of(c)]; }
  /// Number of ids in use or free; ids are 0 .. cell_slots()-1.
  [[nodiscard]] std::size_t cell_slots() const { return cells_.size(); }
  [[nodiscard]] std::size_t cell_count() const { return cells_.size() - free_.size(); }
  /// The cell is alive once it has vertices.
  CellId new_cell();
  void delete_cell(CellId c);
  /// Makes room for the triangulation of this many points, evenly spread; more cells are no error.
  void reserve(std::size_t vertices);

  /// Vertex k of the base lift of a cell is offset * vertex[k].
  [[nodiscard]] Element offset(CellId c, std::size_t k) const { return elements_[cell(c).offset[k]]; }
  [[nodiscard]] Element gluing(CellId c, std::size_t k) const { return elements_[cell(c).gluing[k]]; }
  void set_vertex(CellId c, std::size_t k, VertexId v, const Element& offset) {
    cell(c).vertex[k] = v;
    cell(c).offset[k] = elements_.code(offset);
  }
  void set_neighbour(CellId c, std::size_t k, CellId neighbour, const Element& gluing) {
    cell(c).neighbour[k] = neighbour;
    cell(c).gluing[k] = elements_.code(gluing);
  }

  /// The point s * v.
  [[nodiscard]] Lift lift(VertexId v, const Element& s) const {
    const Vertex& vertex = vertices_[index_of(v)];
    const OrbitPoint point{vertex.point.site, table_->multiply(s, vertex.point.g)};
    // From the base position only for a translation: the filter's error analysis counts one rounding.
    if (s.coset == 0) return {table_->apply(s, vertex.x), point};
    return {table_->apply(point.g, (*sites_)[index_of(vertex.point.site)].approximate), point};
  }
  /// The coordinates of lift(p), and of the lifts of base_lift(c).
  [[nodiscard]] std::array<double, 3> coordinates(const OrbitPoint& p) const {
    return table_->apply(p.g, (*sites_)[index_of(p.site)].approximate);
  }
  [[nodiscard]] std::array<std::array<double, 3>, D + 1> base_coordinates(CellId c) const {
    const Cell& cell = cells_[index_of(c)];
    std::array<std::array<double, 3>, D + 1> x;
    for (std::size_t k = 0; k <= D; ++k) {
      const Element s = elements_[cell.offset[k]];
      const Vertex& vertex = vertices_[index_of(cell.vertex[k])];
      x[k] = s.coset == 0 ? table_->apply(s, vertex.x) : lift(cell.vertex[k], s).x;
    }
    return x;
  }
  [[nodiscard]] Lift lift(const OrbitPoint& p) const {
    return {table_->apply(p.g, (*sites_)[index_of(p.site)].approximate), p};
  }
  [[nodiscard]] std::array<Lift, D + 1> base_lift(CellId c) const {
    const Cell& cell = cells_[index_of(c)];
    std::array<Lift, D + 1> lifts;
    for (std::size_t k = 0; k <= D; ++k) lifts[k] = lift(cell.vertex[k], elements_[cell.offset[k]]);
    return lifts;
  }
  [[nodiscard]] CellPoints<D> base_points(CellId c) const {
    const Cell& cell = cells_[index_of(c)];
    CellPoints<D> points;
    for (std::size_t k = 0; k <= D; ++k)
      points[k] = {vertices_[index_of(cell.vertex[k])].point.site,
                   table_->multiply(elements_[cell.offset[k]], vertices_[index_of(cell.vertex[k])].point.g)};
    return points;
  }

  /// A lift of a cell: `lift` times its base lift.
  struct CellLift {
    CellId cell;
    Element lift;
    friend auto operator<=>(const CellLift&, const CellLift&) = default;
  };
  /// The star of a point p of GP that is a vertex: all lifts of cells with p among their vertices.
  /// Complexity: O(k log k) for k cells.
  [[nodiscard]] std::vector<CellLift> star(const OrbitPoint& p) const;
  [[nodiscard]] CellPoints<D> points(const CellLift& at) const {
    return moved<D + 1>(*table_, at.lift, base_points(at.cell));
  }

  /// A facet of a cell with its canonical key: multiplier * facet = key.
  struct FacetOccurrence {
    std::array<OrbitPoint, D> key;
    Element multiplier;
    CellId cell;
    std::uint32_t facet;
  };
  [[nodiscard]] FacetOccurrence facet(CellId c, std::uint32_t k) const { return facet(c, base_points(c), k); }
  /// The same, given the points of the base lift.
  [[nodiscard]] FacetOccurrence facet(CellId c, const CellPoints<D>& points, std::uint32_t k) const;
  /// Which facet of the neighbour across facet k it is. The gluing decides: the neighbour's id alone may
  /// stand at several facets.
  [[nodiscard]] std::uint32_t mirror_facet(CellId c, std::uint32_t k) const;

  /// Adds a cell given by a lift, vertices in any order, all of whose sites have been added; it has no
  /// neighbours yet. Errors: InternalError if it is flat.
  CellId add_cell(CellPoints<D> points, Predicates<D>& predicates);
  /// Makes the cells of equal facets neighbours. Errors: InternalError if a key does not occur exactly twice.
  /// Complexity: O(n log n) for n facets.
  void glue(const std::vector<FacetOccurrence>& facets);

  /// Fills an empty complex with cells given by lifts (one per H-orbit) as add_cell has them, and finds the
  /// adjacency by facet keys.
  void assemble(const std::vector<CellPoints<D>>& cells, Predicates<D>& predicates);

  /// Takes over the cells of a complex of one orbit on a torus, where they are the same for each point.
  /// Requires: this one has the vertex of one orbit and no cells; the same group and subgroup.
  void assume_cells(const QuotientComplex& of_one_orbit);

  /// The base lifts of all cells.
  [[nodiscard]] std::vector<CellPoints<D>> all_cells() const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  const GroupTable* table_;
  const std::vector<Site>* sites_;
  Subgroup subgroup_;
  std::vector<std::uint32_t> first_vertex_;
  std::vector<Vertex> vertices_;
  std::vector<Cell> cells_;
  std::vector<CellId> free_;
  ElementStore elements_;
};

extern template class QuotientComplex<2>;
extern template class QuotientComplex<3>;

/// The cells of E^d modulo a group, given one lift of each cell modulo a subgroup of index `multiplicity` in
/// it: each as its canonical list, sorted. Nothing if the set of cells is not invariant under the group (some
/// cell does not occur exactly `multiplicity` times).
template <int D>
std::optional<std::vector<CellPoints<D>>> cells_modulo(const GroupTable& table, const Subgroup& group,
                                                       std::vector<CellPoints<D>> cells,
                                                       std::uint32_t multiplicity);

/// The cells modulo `target`, a subgroup of `group`, given one lift of each cell modulo `group`: each moved
/// by all coset representatives, as canonical lists, sorted.
template <int D>
std::vector<CellPoints<D>> unfold(const GroupTable& table, const Subgroup& group, const Subgroup& target,
                                  const std::vector<CellPoints<D>>& cells);

extern template std::optional<std::vector<CellPoints<2>>> cells_modulo<2>(const GroupTable&, const Subgroup&,
                                                                          std::vector<CellPoints<2>>,
                                                                          std::uint32_t);
extern template std::optional<std::vector<CellPoints<3>>> cells_modulo<3>(const GroupTable&, const Subgroup&,
                                                                          std::vector<CellPoints<3>>,
                                                                          std::uint32_t);
extern template std::vector<CellPoints<2>> unfold<2>(const GroupTable&, const Subgroup&, const Subgroup&,
                                                     const std::vector<CellPoints<2>>&);
extern template std::vector<CellPoints<3>> unfold<3>(const GroupTable&, const Subgroup&, const Subgroup&,
                                                     const std::vector<CellPoints<3>>&);

}  // namespace flatdt::ref
