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
#include "flatdt/ref/cells_modulo.hpp"
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

template <int D>
class QuotientComplex {
 public:
  /// 32 bytes. See point().
  struct Vertex {
    std::array<double, 3> x{};  // of base * site
    SiteId site{};
    CellId cell = kNoCell;  // some cell with this vertex
  };
  /// 36 bytes in space, 28 in the plane. See offset() and gluing().
  struct Cell {
    std::array<VertexId, D + 1> vertex;  // kNoVertex first: the slot is free
    std::array<CellId, D + 1> neighbour;
    /// Where its elements stand; 0: all are the identity. Of n evenly spread points' cells these are all but
    /// O(n^(1-1/d)), those at the boundary of the set of base positions.
    std::uint32_t elements = 0;

    [[nodiscard]] bool is_alive() const { return vertex[0] != kNoVertex; }
  };

  QuotientComplex(const GroupTable& table, const std::vector<Site>& sites, Subgroup subgroup)
      : table_(&table),
        sites_(&sites),
        subgroup_(std::move(subgroup)),
        has_one_copy_(subgroup_.index() == 1),
        first_vertex_(sites.size(), kNone) {}

  [[nodiscard]] const GroupTable& table() const { return *table_; }
  [[nodiscard]] const Subgroup& subgroup() const { return subgroup_; }

  /// Adds the [G:H] vertices of a site, without cells. The vertex of coset `rep` has id first + rep.
  void add_site(SiteId site);
  [[nodiscard]] bool has_site(SiteId site) const { return first_vertex_[index_of(site)] != kNone; }
  [[nodiscard]] VertexId vertex_of(SiteId site, std::uint32_t rep) const {
    return VertexId{first_vertex_[index_of(site)] + rep};
  }
  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }
  /// A vertex's site and base, the representative of its coset H g.
  [[nodiscard]] OrbitPoint point(VertexId v) const {
    const SiteId site = vertices_[index_of(v)].site;
    if (has_one_copy_) return {site, Element{}};
    return {site, subgroup_.representative(index_of(v) - first_vertex_[index_of(site)])};
  }
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
  [[nodiscard]] Element offset(CellId c, std::size_t k) const {
    const std::uint32_t e = cell(c).elements;
    return e == 0 ? Element{} : codes_[cell_elements_[e].offset[k]];
  }
  [[nodiscard]] Element gluing(CellId c, std::size_t k) const {
    const std::uint32_t e = cell(c).elements;
    return e == 0 ? Element{} : codes_[cell_elements_[e].gluing[k]];
  }
  /// All offsets and gluings of the cell are the identity. (Not conversely.)
  [[nodiscard]] bool has_no_elements(CellId c) const { return cell(c).elements == 0; }
  void set_vertex(CellId c, std::size_t k, VertexId v, const Element& offset) {
    cell(c).vertex[k] = v;
    if (needs_elements(c, offset)) elements_of(c).offset[k] = codes_.code(offset);
  }
  void set_neighbour(CellId c, std::size_t k, CellId neighbour, const Element& gluing) {
    cell(c).neighbour[k] = neighbour;
    if (needs_elements(c, gluing)) elements_of(c).gluing[k] = codes_.code(gluing);
  }

  /// The point s * v.
  [[nodiscard]] Lift lift(VertexId v, const Element& s) const {
    const OrbitPoint base = point(v);
    const OrbitPoint moved{base.site, table_->multiply(s, base.g)};
    if (is_base_near(s)) return {table_->apply(s, vertices_[index_of(v)].x), moved};
    return {table_->apply(moved.g, approximate(base.site)), moved};
  }
  [[nodiscard]] Lift lift(const OrbitPoint& p) const { return {table_->apply(p.g, approximate(p.site)), p}; }
  /// The site's coordinates rounded, which are those of its first vertex, for the first representative is the
  /// identity.
  [[nodiscard]] std::array<double, 3> approximate(SiteId site) const {
    const std::uint32_t v = first_vertex_[index_of(site)];
    return v == kNone ? (*sites_)[index_of(site)].approximate() : vertices_[v].x;
  }
  /// The coordinates of the lifts of base_lift(c).
  [[nodiscard]] std::array<std::array<double, 3>, D + 1> base_coordinates(CellId c) const {
    const Cell& cell = cells_[index_of(c)];
    std::array<std::array<double, 3>, D + 1> x;
    for (std::size_t k = 0; k <= D; ++k) x[k] = vertices_[index_of(cell.vertex[k])].x;
    if (cell.elements == 0) return x;
    for (std::size_t k = 0; k <= D; ++k) {
      const Element s = offset(c, k);
      x[k] = is_base_near(s) ? table_->apply(s, x[k]) : lift(cell.vertex[k], s).x;
    }
    return x;
  }
  [[nodiscard]] std::array<Lift, D + 1> base_lift(CellId c) const {
    const Cell& cell = cells_[index_of(c)];
    std::array<Lift, D + 1> lifts;
    for (std::size_t k = 0; k <= D; ++k) lifts[k] = lift(cell.vertex[k], offset(c, k));
    return lifts;
  }
  [[nodiscard]] CellPoints<D> base_points(CellId c) const {
    const Cell& cell = cells_[index_of(c)];
    CellPoints<D> points;
    for (std::size_t k = 0; k <= D; ++k) {
      const OrbitPoint base = point(cell.vertex[k]);
      points[k] = {base.site, table_->multiply(offset(c, k), base.g)};
    }
    return points;
  }

  /// The points of GP that edges join to the point of a vertex, sorted. Requires: it is in a cell.
  /// Complexity: O(k log k) for k cells around it, expected (hashing).
  [[nodiscard]] std::vector<OrbitPoint> neighbours(VertexId v) const;

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
  /// The same, in the memory of this complex's cells: they are gone, and with them what a search needs.
  [[nodiscard]] CellList<D> release_cells() &&;

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  /// The elements of a cell, in H, as codes.
  struct CellElements {
    std::array<ElementStore::Code, D + 1> offset;
    std::array<ElementStore::Code, D + 1> gluing;
  };
  [[nodiscard]] bool needs_elements(CellId c, const Element& g) const {
    return cell(c).elements != 0 || !g.is_identity();
  }
  /// Those of the cell, made if it has none.
  CellElements& elements_of(CellId c) {
    if (cell(c).elements == 0) make_elements(c);
    return cell_elements_[cell(c).elements];
  }
  void make_elements(CellId c);
  /// Whether coordinates of s * v may be had from the base position of v: only by a translation, for the
  /// filter's error analysis counts one rounding, and from a base position in or next to the unit cell. In a
  /// cover of n periods base positions are up to n, and their errors, about 2^-53 n, too large for a lift
  /// near 0.
  [[nodiscard]] bool is_base_near(const Element& s) const {
    return s.coset == 0 && subgroup_.has_all_translations();
  }

  const GroupTable* table_;
  const std::vector<Site>* sites_;
  Subgroup subgroup_;
  bool has_one_copy_;
  std::vector<std::uint32_t> first_vertex_;
  std::vector<Vertex> vertices_;
  Records<Cell> cells_;
  std::vector<CellId> free_;
  Records<CellElements> cell_elements_;  // the first is unused
  std::vector<std::uint32_t> free_elements_;
  ElementStore codes_;
};

extern template class QuotientComplex<2>;
extern template class QuotientComplex<3>;

}  // namespace flatdt::ref
