/// Insertion of a point whose conflict region is too large to be searched: on a long lattice with few points
/// it has as many lifts of cells as the aspect ratio, in space its square (INSERTION 3, "Long lattices";
/// docs/theory.md, section 7). Here the cost does not depend on the metric.
#pragma once

#include <optional>
#include <vector>

#include "flatdt/ref/periodic_delaunay.hpp"
#include "lifted_star.hpp"

namespace flatdt::ref {

template <int D>
class LongLatticeStar {
 public:
  /// `located`: a cell in conflict with q. Requires: q is a point of GP whose copies modulo
  /// complex.subgroup() are not vertices yet.
  LongLatticeStar(const Setting<D>& setting, const QuotientComplex<D>& complex, const OrbitPoint& q,
                  const Location& located);

  /// The star of q in DT of the complex's points and Hq. Complexity: one test with each neighbour of one
  /// vertex for each cell that it had while it was searched; a nearest-vertex search for a cell of copies of
  /// q alone, of which few are left where the vertices of the located cell have been inserted.
  [[nodiscard]] std::vector<CellPoints<D>> cells() const { return star_.points(); }
  /// The cells modulo H that are in conflict with some copy of q.
  [[nodiscard]] std::vector<CellId> conflicts() const;

 private:
  using Cell = typename LiftedStar<D>::Cell;
  struct Search {
    bool fits;  // else nothing has been found out
    std::optional<Lift> vertex;
  };
  [[nodiscard]] bool is_copy(const OrbitPoint& p) const {
    return p.site == star_.centre().point.site && complex_->subgroup().split(p.g).rep == rep_;
  }
  void insert_vertices(const Location& located);
  void complete();
  [[nodiscard]] std::optional<Lift> conflicting_vertex(const Cell& cell);
  [[nodiscard]] std::optional<Lift> conflicting_neighbour(const Cell& cell, const OrbitPoint& vertex);
  [[nodiscard]] std::optional<Lift> conflicting_nearest(const std::array<Lift, D + 1>& cell);
  [[nodiscard]] OrbitPoint vertex_near(const Vector& x) const;
  template <class PowerOf>
  [[nodiscard]] Search nearest_in_conflict(const std::array<Lift, D + 1>& cell, OrbitPoint nearest,
                                           const PowerOf& power_of);
  [[nodiscard]] Vector circumcentre(const CellPoints<D>& cell) const;
  template <class Visit>
  void visit_neighbours(const OrbitPoint& p, const Visit& visit);

  Setting<D> setting_;
  const QuotientComplex<D>* complex_;
  CellId located_;
  std::uint32_t rep_;                                // of the coset of q modulo H
  std::vector<std::vector<OrbitPoint>> neighbours_;  // by vertex: those of its point, once asked for
  LiftedStar<D> star_;
  StarFilter<D> around_;  // has seen points around the star, too
};

extern template class LongLatticeStar<2>;
extern template class LongLatticeStar<3>;

}  // namespace flatdt::ref
