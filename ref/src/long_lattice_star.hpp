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
  /// Requires: q is a point of GP whose copies modulo complex.subgroup() are not vertices yet.
  LongLatticeStar(const Setting<D>& setting, const QuotientComplex<D>& complex, const OrbitPoint& q);

  /// The star of q in DT of the complex's points and Hq. Complexity: one nearest-vertex search for each cell
  /// that it ever had.
  [[nodiscard]] std::vector<CellPoints<D>> cells() const { return star_.points(); }
  /// The cells modulo H that are in conflict with some copy of q. `located`: one of them.
  [[nodiscard]] std::vector<CellId> conflicts(CellId located) const;

 private:
  struct Search {
    bool fits;  // else nothing has been found out
    std::optional<Lift> vertex;
  };
  [[nodiscard]] OrbitPoint vertex_near(const std::array<double, 3>& x) const;
  [[nodiscard]] OrbitPoint about_nearest(const std::array<Lift, D + 1>& cell);
  template <class PowerOf>
  [[nodiscard]] Search nearest_in_conflict(const std::array<Lift, D + 1>& cell, OrbitPoint nearest,
                                           const PowerOf& power_of);
  [[nodiscard]] std::optional<Lift> conflicting_vertex(const std::array<Lift, D + 1>& cell);
  [[nodiscard]] Vector circumcentre(const CellPoints<D>& cell) const;
  [[nodiscard]] const std::vector<OrbitPoint>& link(VertexId v);
  template <class Visit>
  void visit_neighbours(const OrbitPoint& p, const Visit& visit);

  Setting<D> setting_;
  const QuotientComplex<D>* complex_;
  std::vector<std::vector<OrbitPoint>> links_;  // by vertex: the neighbours of its point, once asked for
  LiftedStar<D> star_;
};

extern template class LongLatticeStar<2>;
extern template class LongLatticeStar<3>;

}  // namespace flatdt::ref
