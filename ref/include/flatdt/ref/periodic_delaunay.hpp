/// An incremental Delaunay triangulation of E^d/H: H a sublattice while covering (Section 4) and then the
/// whole group G, or G from the first point on (insertion without covers; docs/theory.md, section 7).
/// Role: one level of the Delaunay hierarchy. It locates points, finds conflict regions over lifts,
/// stars the hole, and keeps the list L of cells whose empty ball is too large for Corollary 9.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "flatdt/ref/circumradius.hpp"
#include "flatdt/ref/quotient_complex.hpp"

namespace flatdt::ref {

inline constexpr std::size_t kRegionLimit = 250;

/// Everything the levels share.
template <int D>
struct Setting {
  const Frame* frame;
  const GroupTable* table;
  const std::vector<Site>* sites;
  const TieOrder* order;
  Predicates<D>* predicates;
  Circumradius<D>* circumradius;
  /// Without covers, a search that has met more than this many further lifts of cells it had met before is
  /// given up: the star of the point is found from its own copies instead, at a cost that does not depend on
  /// the metric. 0: no search (tests do). At canonical metrics regions have at most 77 lifts in all
  /// (INSERTION 5).
  std::size_t region_limit = kRegionLimit;
};

/// A cell and the query point seen from its base lift.
struct Location {
  CellId cell = kNoCell;
  Element seen;  // seen * site is the query in the coordinates of the cell's base lift
};

/// How orbits are inserted.
enum class Insertion : std::uint8_t {
  covering,       // Section 4: all copies modulo a sublattice until Corollary 9 is met
  without_covers  // modulo a fixed group from the first point on
};

template <int D>
class PeriodicDelaunay {
 public:
  /// Requires for without_covers: `subgroup` is the tie order's invariance group, or the whole group. If
  /// that is more than the invariance group, orbits are inserted by rank: see needs_smaller_group().
  PeriodicDelaunay(const Setting<D>& setting, const Subgroup& subgroup,
                   Insertion insertion = Insertion::covering);

  /// The first orbit, as a block: cells modulo the tie order's invariance group.
  void start(SiteId site, const std::vector<CellPoints<D>>& cells);

  /// The same on a torus, without covers: its cells are those of any orbit.
  void start(SiteId site, const QuotientComplex<D>& of_one_orbit);

  [[nodiscard]] const QuotientComplex<D>& complex() const { return complex_; }
  [[nodiscard]] QuotientComplex<D> release_complex() && { return std::move(complex_); }
  [[nodiscard]] bool is_on_manifold() const { return complex_.subgroup().is_whole(); }
  /// Inserting by rank (docs/theory.md, section 7) a tie was met that the ranks of the orbits do not decide,
  /// or a long lattice. The complex has then not been changed and will not be any more: start again modulo
  /// the tie order's invariance group.
  [[nodiscard]] bool needs_smaller_group() const { return needs_smaller_group_; }

  /// Number of vertices that an orbit has here: [G:H].
  [[nodiscard]] std::uint32_t copies() const { return complex_.subgroup().index(); }

  /// A cell whose base lift, with the query at `seen`, contains the query in its closure.
  /// `query` is the element g of the query point g * site; the walk starts at the point `near` of the orbit
  /// set. Termination: a visibility walk in a regular triangulation of E^d cannot cycle [Edelsbrunner90].
  [[nodiscard]] Location locate(SiteId site, const Element& query, const OrbitPoint& near);
  /// A point of GP to start from when nothing nearer is known.
  [[nodiscard]] OrbitPoint start_near(const Lift& query) const;
  /// The vertex (a point of GP) of the located cell nearest to the query, in the query's own coordinates.
  [[nodiscard]] OrbitPoint nearest_vertex(SiteId site, const Element& query, const Location& at) const;

  /// Inserts copy `rep` of a site (Section 4.2). add_site must have been called for its orbit.
  /// Where copies of the point may be neighbours, that is where a lift of a cell of the conflict region is in
  /// the region again or next to it, the star is computed among its own copies first (docs/theory.md, section
  /// 7). In a cover that is safe in the sense of cover.hpp this cannot happen: then it is an InternalError.
  void insert(SiteId site, std::uint32_t rep, const Location& at);
  void add_site(SiteId site) { complex_.add_site(site); }
  /// Makes room for the triangulation of this many orbits.
  void reserve(std::size_t orbits) { complex_.reserve(orbits * copies()); }

  /// Number of cells in L: those with 16 R^2 >= delta^2.
  [[nodiscard]] std::size_t large_cells() const { return large_cells_; }
  [[nodiscard]] bool is_large(CellId c) const { return index_of(c) < large_.size() && large_[index_of(c)]; }
  /// Step 2 of Section 4.1. Requires: L is empty and whole orbits only.
  void convert_to_manifold();

 private:
  /// A facet of the boundary of the conflict region, in the coordinates where the new vertex is at its base
  /// position.
  struct BoundaryFacet {
    CellId outside;
    std::uint32_t outside_facet;
    Element outside_lift;
    std::uint32_t hole;  // position of the new vertex among the D+1
    std::array<VertexId, D + 1> vertex;
    std::array<Element, D + 1> offset;
  };
  struct Ridge {
    std::array<std::pair<VertexId, Element>, D - 1> key;
    CellId cell;
    std::uint32_t facet;
  };
  /// A lift of a cell met by a search: from it the query point is seen at `seen`.
  struct Visit {
    CellId cell;
    Element seen;
    bool conflict;
    std::uint32_t previous;  // of the same cell
  };
  /// An entry of the open hash table of visits; free unless of the present search.
  struct VisitEntry {
    std::uint32_t search = 0;
    std::uint32_t visit = 0;
  };
  static constexpr std::uint32_t kNoVisit = 0xffffffffU;
  static constexpr std::uint32_t kNoRidge = 0xffffffffU;

  /// Whether the whole region has been found.
  [[nodiscard]] bool collect_conflicts(const OrbitPoint& q, const Location& at);
  [[nodiscard]] const Visit* find_visit(const Location& where) const;
  void record_visit(const Location& where, bool conflict);
  [[nodiscard]] bool in_conflict(CellId c, const OrbitPoint& seen) const;
  /// By rank: was there a tie since start() that the ranks did not decide?
  [[nodiscard]] bool met_undecided_tie() const {
    return by_rank_ && setting_.predicates->ties_within_orbits() != ties_of_first_orbit_;
  }
  void add_boundary_facet(const Location& inside, std::uint32_t facet, const Element& lift);
  /// The latest visit of a cell in the present search.
  [[nodiscard]] std::uint32_t last_visit(CellId c) const {
    const VisitEntry& entry = visit_table_[visit_slot(c)];
    return entry.search == search_ ? entry.visit : kNoVisit;
  }
  void begin_search();
  void grow_visit_table();
  /// Where it stands in the table, or will stand. Bounded: the table is at most half full.
  [[nodiscard]] std::size_t visit_slot(CellId c) const {
    const std::size_t mask = visit_table_.size() - 1;
    std::size_t slot = index_of(c) * 0x9e3779b97f4a7c15ULL >> 32U & mask;
    while (visit_table_[slot].search == search_ && visits_[visit_table_[slot].visit].cell != c)
      slot = (slot + 1) & mask;
    return slot;
  }
  void glue_at_ridge(const Ridge& ridge);
  void star_hole(VertexId q);
  [[nodiscard]] std::vector<Lift> possible_own_neighbours(const OrbitPoint& q) const;
  [[nodiscard]] std::vector<CellPoints<D>> star_among_own_copies(const OrbitPoint& q) const;
  void replace_by_star(const std::vector<CellPoints<D>>& star, std::vector<CellId> removed);
  void note_new(CellId c);
  void note_deleted(CellId c);

  Setting<D> setting_;
  Insertion insertion_;
  QuotientComplex<D> complex_;
  bool by_rank_ = false;
  bool needs_smaller_group_ = false;
  std::size_t ties_of_first_orbit_ = 0;
  std::size_t large_cells_ = 0;
  std::vector<bool> large_;  // by cell: belongs to the list L (Section 4.1)
  std::uint64_t walk_state_ = 0x9e3779b97f4a7c15ULL;
  // Kept between insertions.
  std::vector<Visit> visits_;
  std::vector<VisitEntry> visit_table_;  // the latest visit of each cell; its size is a power of two
  std::uint32_t search_ = 0;
  std::array<double, 3> query_{};  // of the present search, the site's own coordinates
  bool meets_own_copies_ = false;
  std::size_t repeated_visits_ = 0;  // visits of cells that had been visited through another lift
  std::size_t region_limit_;         // lower after a search that was given up, until one is not
  std::vector<Location> region_;
  std::vector<BoundaryFacet> boundary_;
  std::vector<Ridge> ridges_;
  std::vector<std::uint32_t> ridge_table_;  // open addressing: indices of ridges_
  std::size_t glued_ridges_ = 0;
};

extern template class PeriodicDelaunay<2>;
extern template class PeriodicDelaunay<3>;

}  // namespace flatdt::ref
