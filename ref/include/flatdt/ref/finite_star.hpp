/// The star of a point q in the (perturbed) Delaunay triangulation of q and finitely many candidates, when q
/// is in the interior of their convex hull. Method: one cell by the simplex method (the cell of the star that
/// a generic ray from q enters minimises the lifted height just beside q), the others by wrapping the facets
/// through q.
#pragma once

#include <set>
#include <vector>

#include "flatdt/ref/quotient_complex.hpp"

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

  [[nodiscard]] Sign orientation(const Apexes& apexes) const;
  [[nodiscard]] std::array<Lift, D + 1> oriented(const Apexes& apexes, Sign& sign) const;
  [[nodiscard]] bool contains_ray(const Apexes& apexes) const;
  [[nodiscard]] Apexes first_cell();
  [[nodiscard]] Apexes wrap(const Apexes& apexes, std::size_t opposite);

  Predicates<D>* predicates_;
  Lift q_;
  std::vector<Lift> candidates_;
};

extern template class FiniteStar<2>;
extern template class FiniteStar<3>;

}  // namespace flatdt::ref
