/// The Delaunay triangulation of one orbit Gq, by enumeration of the possible neighbours of q.
/// Source: DESIGN, "Covers" (the first orbit is inserted as a block); INSERTION 4 (the candidates).
#pragma once

#include <vector>

#include "flatdt/ref/quotient_complex.hpp"

namespace flatdt::ref {

/// The star of a point q of GP in DT(Hq), H a subgroup with all translations of G. Each cell starts with q.
/// Complexity: as below.
template <int D>
std::vector<CellPoints<D>> star_in_own_orbit(const Frame& frame, const GroupTable& table,
                                             const std::vector<Site>& sites, Predicates<D>& predicates,
                                             const Subgroup& subgroup, const OrbitPoint& q);

/// One lift of each cell of DT(Gq) modulo the invariance group of the tie order, as canonical lists, sorted.
/// Complexity: O(|star| * candidates) predicates; at most 4^d candidates per coset, for any metric.
template <int D>
std::vector<CellPoints<D>> triangulate_first_orbit(const Frame& frame, const GroupTable& table,
                                                   const std::vector<Site>& sites, const TieOrder& order,
                                                   Predicates<D>& predicates, SiteId site);

extern template std::vector<CellPoints<2>> star_in_own_orbit<2>(const Frame&, const GroupTable&,
                                                                const std::vector<Site>&, Predicates<2>&,
                                                                const Subgroup&, const OrbitPoint&);
extern template std::vector<CellPoints<3>> star_in_own_orbit<3>(const Frame&, const GroupTable&,
                                                                const std::vector<Site>&, Predicates<3>&,
                                                                const Subgroup&, const OrbitPoint&);
extern template std::vector<CellPoints<2>> triangulate_first_orbit<2>(const Frame&, const GroupTable&,
                                                                      const std::vector<Site>&,
                                                                      const TieOrder&, Predicates<2>&,
                                                                      SiteId);
extern template std::vector<CellPoints<3>> triangulate_first_orbit<3>(const Frame&, const GroupTable&,
                                                                      const std::vector<Site>&,
                                                                      const TieOrder&, Predicates<3>&,
                                                                      SiteId);

}  // namespace flatdt::ref
