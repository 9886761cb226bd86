#include "flatdt/ref/first_orbit.hpp"

#include <algorithm>
#include <cstdlib>

#include "finite_star.hpp"
#include "flatdt/ref/lattice.hpp"
#include "flatdt/ref/orbit_position.hpp"
#include "small_closest_vectors.hpp"

namespace flatdt::ref {
namespace {

/// The elements {e - 2s} r with s closest to (u + e)/2, u = r q - p, for all e in {0,1}^d; in rationals.
void add_candidates(const Frame& frame, const GroupTable& table, const Vector& q, const Vector& p,
                    std::uint16_t coset, std::vector<Element>& candidates) {
  const int d = frame.dimension;
  const Isometry r = table.isometry(Element{{}, coset});
  const Vector u = r * q - p;
  for (int e = 0; e < (1 << d); ++e) {
    Vector shifted = u;
    Vector shift(d);
    for (int i = 0; i < d; ++i)
      if (((e >> i) & 1) != 0) {
        shifted[i] += 1;
        shift[i] = 1;
      }
    for (const Vector& s : closest_vectors(frame.gram, Rational(Integer(1), Integer(2)) * shifted))
      candidates.push_back(table.element(Isometry::translate(shift - Rational(2) * s) * r));
  }
}

/// The same in machine integers; false where the numbers do not fit, candidates then as before.
bool add_small_candidates(const SmallClosestVectors& closest, const GroupTable& table, const Site& q,
                          const Element& g, std::uint16_t coset, std::vector<Element>& candidates) {
  const auto d = static_cast<std::size_t>(table.dimension());
  const std::int64_t denominator = q.form->small_denominator;
  // The search takes 2^60 for twice the denominator, and coordinates must stay below 2^62.
  std::int64_t reach = table.row_sum() + 1;
  for (const std::int16_t t : g.t) reach = std::max<std::int64_t>(reach, table.row_sum() + 1 + std::abs(t));
  if (denominator >= std::int64_t{1} << 58U || static_cast<Int128>(denominator) * reach >= std::int64_t{1}
                                                                                               << 61U)
    return false;
  std::array<std::int64_t, 3> u{};
  const std::array<std::int64_t, 3> there = table.apply(Element{{}, coset}, q.small, denominator);
  const std::array<std::int64_t, 3> here = table.apply(g, q.small, denominator);
  for (std::size_t i = 0; i < d; ++i) u[i] = there[i] - here[i];
  const std::size_t before = candidates.size();
  for (unsigned e = 0; e < (1U << d); ++e) {
    std::array<std::int64_t, 3> shifted = u;
    for (std::size_t i = 0; i < d; ++i)
      if ((e >> i & 1U) != 0) shifted[i] += denominator;
    const auto vectors = closest(shifted, 2 * denominator);
    if (!vectors) {
      candidates.resize(before);
      return false;
    }
    for (const auto& s : *vectors) {
      std::array<std::int64_t, 3> t{};
      for (std::size_t i = 0; i < d; ++i) t[i] = static_cast<std::int64_t>(e >> i & 1U) - 2 * s[i];
      candidates.push_back(table.translated(t, coset));
    }
  }
  return true;
}

/// All points of Hp that can be neighbours of p = g q in DT(Hp), and p + e_i first.
/// Neighbours lie in p + 2V, V the closed Voronoi cell of the lattice, so each is, for a coset r and u = rq -
/// p and some e in {0,1}^d, the point rq + e - 2s with s a lattice vector closest to (u + e)/2 (INSERTION 4).
std::vector<OrbitPoint> neighbour_candidates(const Frame& frame, const GroupTable& table,
                                             const std::vector<Site>& sites, const Subgroup& subgroup,
                                             SiteId id, const Element& g, bool in_machine_integers) {
  const int d = frame.dimension;
  const Site& site = sites[index_of(id)];
  const auto closest =
      in_machine_integers && !site.is_large() ? SmallClosestVectors::make(frame.gram) : std::nullopt;
  const Element back = table.inverse(g);
  std::vector<Element> elements;
  for (int c = 0; c < table.cosets(); ++c) {
    const auto coset = static_cast<std::uint16_t>(c);
    // H contains the lattice, so that a coset of it is in Hg or disjoint from it.
    if (subgroup.split(table.multiply(Element{{}, coset}, back)).rep != 0) continue;
    if (closest && add_small_candidates(*closest, table, site, g, coset, elements)) continue;
    const Vector q = position(table, sites, {id, Element{}});
    add_candidates(frame, table, q, table.isometry(g) * q, coset, elements);
  }
  std::vector<OrbitPoint> candidates;
  for (const Element& h : elements)
    if (h != g) candidates.push_back({id, h});
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
std::vector<CellPoints<D>> star_in_own_orbit(const Frame& frame, const GroupTable& table,
                                             const std::vector<Site>& sites, Predicates<D>& predicates,
                                             const Subgroup& subgroup, const OrbitPoint& q) {
  return FiniteStar<D>(
             table, sites, predicates, q,
             neighbour_candidates(frame, table, sites, subgroup, q.site, q.g, predicates.uses_fixed()))
      .cells();
}

template <int D>
std::vector<CellPoints<D>> triangulate_first_orbit(const Frame& frame, const GroupTable& table,
                                                   const std::vector<Site>& sites, const TieOrder& order,
                                                   Predicates<D>& predicates, SiteId site) {
  const Subgroup& group = order.invariance_group();
  std::vector<CellPoints<D>> stars;
  // One star for each orbit of vertices modulo the invariance group: one, or two for the didicosm.
  for (std::uint32_t rep = 0; rep < group.index(); ++rep) {
    const std::vector<CellPoints<D>> star = star_in_own_orbit<D>(
        frame, table, sites, predicates, Subgroup::whole(table), {site, group.representative(rep)});
    stars.insert(stars.end(), star.begin(), star.end());
  }
  // Each of the d+1 vertices of a cell is equivalent to exactly one of the centres: the cell occurs d+1
  // times.
  auto cells = cells_modulo<D>(table, group, stars, D + 1);
  ensure(cells.has_value(), "the stars of one orbit fit together");
  return *std::move(cells);
}

template std::vector<CellPoints<2>> star_in_own_orbit<2>(const Frame&, const GroupTable&,
                                                         const std::vector<Site>&, Predicates<2>&,
                                                         const Subgroup&, const OrbitPoint&);
template std::vector<CellPoints<3>> star_in_own_orbit<3>(const Frame&, const GroupTable&,
                                                         const std::vector<Site>&, Predicates<3>&,
                                                         const Subgroup&, const OrbitPoint&);
template std::vector<CellPoints<2>> triangulate_first_orbit<2>(const Frame&, const GroupTable&,
                                                               const std::vector<Site>&, const TieOrder&,
                                                               Predicates<2>&, SiteId);
template std::vector<CellPoints<3>> triangulate_first_orbit<3>(const Frame&, const GroupTable&,
                                                               const std::vector<Site>&, const TieOrder&,
                                                               Predicates<3>&, SiteId);

}  // namespace flatdt::ref
