/// An incremental Delaunay triangulation of E^d/H (Section 4): H a sublattice while covering, then the whole
/// group G. Role: one level of the Delaunay hierarchy. It locates points, finds conflict regions over lifts,
/// stars the hole, and keeps the list L of cells whose empty ball is too large for Corollary 9.
#pragma once

#include <cstdint>
#include <vector>

#include "flatdt/ref/circumradius.hpp"
#include "flatdt/ref/quotient_complex.hpp"

namespace flatdt::ref {

/// Everything the levels share.
template <int D>
struct Setting {
  const Frame* frame;
  const GroupTable* table;
  const std::vector<Site>* sites;
  const TieOrder* order;
  Predicates<D>* predicates;
  Circumradius<D>* circumradius;
};

/// A cell and the query point seen from its base lift.
struct Location {
  CellId cell = kNoCell;
  Element seen;  // seen * site is the query in the coordinates of the cell's base lift
};

template <int D>
class PeriodicDelaunay {
 public:
  PeriodicDelaunay(const Setting<D>& setting, const Subgroup& subgroup);

  /// The first orbit, as a block: cells modulo the tie order's invariance group.
  void start(SiteId site, const std::vector<CellPoints<D>>& cells);

  [[nodiscard]] const QuotientComplex<D>& complex() const { return complex_; }
  [[nodiscard]] bool is_on_manifold() const { return complex_.subgroup().is_whole(); }

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
  /// Precondition of the algorithm: the result is a simplicial complex modulo H; asserted through "no cell of
  /// the conflict region occurs twice modulo H".
  void insert(SiteId site, std::uint32_t rep, const Location& at);
  void add_site(SiteId site) { complex_.add_site(site); }

  /// Number of cells in L: those with 16 R^2 >= delta^2.
  [[nodiscard]] std::size_t large_cells() const { return large_cells_; }
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

  void collect_conflicts(SiteId site, const Element& base, const Location& at);
  [[nodiscard]] bool in_conflict(CellId c, const OrbitPoint& seen) const;
  void add_boundary_facet(const Location& inside, std::uint32_t facet, const Element& lift);
  void star_hole(VertexId q);
  void note_new(CellId c);
  void note_deleted(CellId c);

  Setting<D> setting_;
  QuotientComplex<D> complex_;
  std::size_t large_cells_ = 0;
  std::uint32_t visit_ = 0;
  std::uint64_t walk_state_ = 0x9e3779b97f4a7c15ULL;
  // Kept between insertions.
  std::vector<Location> region_;
  std::vector<BoundaryFacet> boundary_;
  std::vector<Ridge> ridges_;
};

extern template class PeriodicDelaunay<2>;
extern template class PeriodicDelaunay<3>;

}  // namespace flatdt::ref
