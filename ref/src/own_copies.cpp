/// Insertion of a point some of whose own copies become its neighbours, so that its conflict region does not
/// embed in E^d/H (INSERTION 3; proof in docs/theory.md, section 7).
#include <algorithm>

#include "flatdt/ref/periodic_delaunay.hpp"
#include "lifted_star.hpp"

namespace flatdt::ref {

/// The copies w q, w != 1, with w = h1 h2^-1 for lifts h1 c, h2 c of one cell c, of which h2 c is in the
/// conflict region and h1 c in it or next to it; nearest first. Overlaps of the regions alone would not do:
/// two regions that only touch along a facet can have neighbours for centres.
template <int D>
std::vector<Lift> PeriodicDelaunay<D>::possible_own_neighbours(const OrbitPoint& q) const {
  const GroupTable& table = *setting_.table;
  std::vector<Element> found;
  found.reserve(4 * region_.size());
  for (const Location& here : region_) {
    // With h = base * seen^-1, the copy h1 h2^-1 q is base * seen1^-1 * seen2 applied to the site.
    for (std::uint32_t v = last_visit(here.cell); v != kNoVisit; v = visits_[v].previous)
      if (visits_[v].seen != here.seen)
        found.push_back(table.multiply(q.g, table.multiply(table.inverse(visits_[v].seen), here.seen)));
  }
  std::sort(found.begin(), found.end(),
            [](const Element& g, const Element& h) { return g.packed() < h.packed(); });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  const Lift centre = complex_.lift(q);
  std::vector<std::pair<double, Lift>> sorted;
  sorted.reserve(found.size());
  for (const Element& g : found) {
    const Lift copy = complex_.lift(OrbitPoint{q.site, g});
    sorted.emplace_back(setting_.predicates->filter().approximate_squared_distance(centre.x, copy.x), copy);
  }
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.point < b.second.point;
  });
  std::vector<Lift> copies;
  copies.reserve(sorted.size());
  for (const auto& [distance, copy] : sorted) copies.push_back(copy);
  return copies;
}

/// The star of q in DT(GP u Gq) is its star in DT of GP, q and the copies above.
template <int D>
std::vector<CellPoints<D>> PeriodicDelaunay<D>::star_among_own_copies(const OrbitPoint& q) const {
  LiftedStar<D> star(complex_.lift(q), *setting_.predicates);
  for (const BoundaryFacet& b : boundary_) {
    std::array<Lift, D + 1> cell;
    for (std::size_t k = 0; k <= D; ++k)
      cell[k] = k == b.hole ? star.centre() : complex_.lift(b.vertex[k], b.offset[k]);
    star.add(cell);
  }
  for (const Lift& copy : possible_own_neighbours(q)) star.insert(copy);
  return star.points();
}

/// Puts the star modulo H in the place of the cells `removed`.
template <int D>
void PeriodicDelaunay<D>::replace_by_star(const std::vector<CellPoints<D>>& star,
                                          std::vector<CellId> removed) {
  // A cell with k vertices in the orbit of q occurs k times in the star modulo H.
  std::vector<CellPoints<D>> cells;
  cells.reserve(star.size());
  for (const CellPoints<D>& cell : star)
    cells.push_back(canonical_face<D + 1>(*setting_.table, complex_.subgroup(), cell).key);
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());

  std::sort(removed.begin(), removed.end());
  removed.erase(std::unique(removed.begin(), removed.end()), removed.end());
  std::vector<typename QuotientComplex<D>::FacetOccurrence> facets;
  facets.reserve((removed.size() + cells.size()) * (D + 1));
  for (const CellId c : removed)
    for (std::uint32_t k = 0; k <= D; ++k) {
      const CellId outside = complex_.cell(c).neighbour[k];
      if (std::binary_search(removed.begin(), removed.end(), outside)) continue;
      facets.push_back(complex_.facet(outside, complex_.mirror_facet(c, k)));
    }
  for (const CellId c : removed) complex_.delete_cell(c);
  for (const CellPoints<D>& points : cells) {
    const CellId c = complex_.add_cell(points, *setting_.predicates);
    const CellPoints<D> base = complex_.base_points(c);
    for (std::uint32_t k = 0; k <= D; ++k) facets.push_back(complex_.facet(c, base, k));
  }
  complex_.glue(facets);
}

template std::vector<Lift> PeriodicDelaunay<2>::possible_own_neighbours(const OrbitPoint&) const;
template std::vector<Lift> PeriodicDelaunay<3>::possible_own_neighbours(const OrbitPoint&) const;
template std::vector<CellPoints<2>> PeriodicDelaunay<2>::star_among_own_copies(const OrbitPoint&) const;
template std::vector<CellPoints<3>> PeriodicDelaunay<3>::star_among_own_copies(const OrbitPoint&) const;
template void PeriodicDelaunay<2>::replace_by_star(const std::vector<CellPoints<2>>&, std::vector<CellId>);
template void PeriodicDelaunay<3>::replace_by_star(const std::vector<CellPoints<3>>&, std::vector<CellId>);

}  // namespace flatdt::ref
