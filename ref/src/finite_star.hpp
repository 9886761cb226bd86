/// The star of a point q in the (perturbed) Delaunay triangulation of q and finitely many candidates, when q
/// is in the interior of their convex hull. Method: one cell by the simplex method (the cell of the star that
/// a generic ray from q enters minimises the lifted height just beside q), the others by wrapping the facets
/// through q.
#pragma once

#include <set>
#include <vector>

#include "flatdt/ref/quotient_complex.hpp"
#include "star_filter.hpp"

namespace flatdt::ref {

template <int D>
class FiniteStar {
 public:
  /// Requires: candidates[0..D-1] are q + e_1, ..., q + e_D with e the basis of the frame (so that their cone
  /// contains the ray); no candidate is q.
  FiniteStar(const GroupTable& table, const std::vector<Site>& sites, Predicates<D>& predicates,
             const OrbitPoint& q, const std::vector<OrbitPoint>& candidates);

  /// The cells of the star; each list starts with q.
  std::vector<CellPoints<D>> cells();

 private:
  using Apexes = std::array<std::size_t, D>;  // candidate indices of the vertices other than q

  [[nodiscard]] std::array<Lift, D + 1> lifts(const Apexes& apexes) const;
  [[nodiscard]] Sign orientation(const Apexes& apexes) const;
  /// orientation() of many cells that differ in one apex.
  [[nodiscard]] typename StarFilter<D>::Plane plane(const Apexes& apexes, std::size_t opposite) const;
  [[nodiscard]] Sign orientation(const typename StarFilter<D>::Plane& plane, const Apexes& apexes,
                                 std::size_t opposite) const;
  /// A cell to test many candidates against.
  struct Ball {
    std::array<Lift, D + 1> lifts;  // positively oriented
    typename StarFilter<D>::Sphere sphere;
  };
  [[nodiscard]] Ball ball(const Apexes& apexes) const;
  [[nodiscard]] bool in_conflict(const Ball& ball, std::size_t candidate) const;
  [[nodiscard]] bool contains_ray(const Apexes& apexes) const;
  [[nodiscard]] Apexes first_cell();
  [[nodiscard]] Apexes wrap(const Apexes& apexes, std::size_t opposite);

  Predicates<D>* predicates_;
  Lift q_;
  std::vector<Lift> candidates_;
  StarFilter<D> filter_;
  std::vector<typename StarFilter<D>::Offset> offsets_;  // by candidate
};

extern template class FiniteStar<2>;
extern template class FiniteStar<3>;

}  // namespace flatdt::ref
