#include "flatdt/ref/first_orbit.hpp"

#include <algorithm>

#include "flatdt/ref/finite_star.hpp"
#include "flatdt/ref/lattice.hpp"

namespace flatdt::ref {
namespace {

/// All points of Gq that can be neighbours of p = g q in DT(Gq), and p + e_i first.
/// Neighbours lie in p + 2V, V the closed Voronoi cell of the lattice, so each is, for a coset r and u = rq -
/// p and some e in {0,1}^d, the point rq + e - 2s with s a lattice vector closest to (u + e)/2 (INSERTION 4).
std::vector<OrbitPoint> neighbour_candidates(const Frame& frame, const GroupTable& table, const Site& site,
                                             SiteId id, const Element& g) {
  const int d = frame.dimension;
  Vector q(d);
  for (int i = 0; i < d; ++i)
    q[i] = Rational(Integer(site.numerators[static_cast<std::size_t>(i)]), Integer(site.denominator));
  const Vector p = table.isometry(g) * q;
  std::vector<OrbitPoint> candidates;
  for (int c = 0; c < table.cosets(); ++c) {
    const Isometry r = table.isometry(Element{{}, static_cast<std::uint16_t>(c)});
    const Vector u = r * q - p;
    for (int e = 0; e < (1 << d); ++e) {
      Vector shifted = u;
      Vector shift(d);
      for (int i = 0; i < d; ++i)
        if (((e >> i) & 1) != 0) {
          shifted[i] += 1;
          shift[i] = 1;
        }
      for (const Vector& s : closest_vectors(frame.gram, Rational(Integer(1), Integer(2)) * shifted)) {
        const Vector translation = shift - Rational(2) * s;
        const Element h = table.element(Isometry::translate(translation) * r);
        if (h != g) candidates.push_back({id, h});
      }
    }
  }
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::vector<OrbitPoint> result;
  for (int i = 0; i < d; ++i) {
    Element unit{};
    unit.t[static_cast<std::size_t>(i)] = 1;
    result.push_back({id, table.multiply(unit, g)});
  }
  for (const OrbitPoint& candidate : candidates)
    if (std::find(result.begin(), result.begin() + d, candidate) == result.begin() + d)
      result.push_back(candidate);
  return result;
}

}  // namespace

template <int D>
std::vector<CellPoints<D>> triangulate_first_orbit(const Frame& frame, const GroupTable& table,
                                                   const std::vector<Site>& sites, const TieOrder& order,
                                                   Predicates<D>& predicates, SiteId site) {
  const Subgroup& group = order.invariance_group();
  std::vector<CellPoints<D>> stars;
  // One star for each orbit of vertices modulo the invariance group: one, or two for the didicosm.
  for (std::uint32_t rep = 0; rep < group.index(); ++rep) {
    const OrbitPoint q{site, group.representative(rep)};
    const std::vector<OrbitPoint> candidates =
        neighbour_candidates(frame, table, sites[index_of(site)], site, q.g);
    const std::vector<CellPoints<D>> star = FiniteStar<D>(table, sites, predicates, q, candidates).cells();
    stars.insert(stars.end(), star.begin(), star.end());
  }
  // Each of the d+1 vertices of a cell is equivalent to exactly one of the centres: the cell occurs d+1
  // times.
  auto cells = cells_modulo<D>(table, group, stars, D + 1);
  ensure(cells.has_value(), "the stars of one orbit fit together");
  return *std::move(cells);
}

template std::vector<CellPoints<2>> triangulate_first_orbit<2>(const Frame&, const GroupTable&,
                                                               const std::vector<Site>&, const TieOrder&,
                                                               Predicates<2>&, SiteId);
template std::vector<CellPoints<3>> triangulate_first_orbit<3>(const Frame&, const GroupTable&,
                                                               const std::vector<Site>&, const TieOrder&,
                                                               Predicates<3>&, SiteId);

}  // namespace flatdt::ref
