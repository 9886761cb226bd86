/// Loops and 2-cycles of the 1-skeleton modulo a group: the criterion of Theorem 7 (and its converse) for
/// E^d/H to carry the triangulation.
#pragma once

#include <optional>
#include <vector>

#include "flatdt/ref/quotient_complex.hpp"

namespace flatdt::ref {

/// A cycle of length at most 2: the edges from `first` to g * second and to h * second, modulo the group. A
/// loop has first == second and only one edge (g; h is unused).
struct ShortCycle {
  bool loop = false;
  SiteId first{};
  SiteId second{};
  Element g;
  Element h;
};

/// The first loop, else the first 2-cycle (in canonical order) of the edges of the cells modulo G, if any.
/// Complexity: O(n log n) for n cells.
template <int D>
std::optional<ShortCycle> find_short_cycle(const GroupTable& table, const std::vector<CellPoints<D>>& cells);

/// The translations t != 0 for which a lattice with t in it makes a loop or a 2-cycle of the edges: the
/// quotients g h^-1 of elements that take one point to two neighbours of one point of GP, or to itself and to
/// a neighbour. Up to the linear parts of `group`, modulo which the cells are given; sorted. Law: for a
/// sublattice S that is invariant under them, E^d/S carries the triangulation iff S contains none (Theorem 7
/// and its converse). Complexity: O(n log n) for n cells; a point has O(1) neighbours in one orbit, for they
/// lie within 2V (INSERTION 4).
template <int D>
std::vector<Element> cycle_translations(const GroupTable& table, const Subgroup& group,
                                        const std::vector<CellPoints<D>>& cells);

/// Does E^d/S have a loop or a 2-cycle, S a sublattice that is invariant under the linear parts of `group`,
/// modulo which the cells are given? Law: iff S contains one of the translations above. Complexity: O(n log
/// n) for n cells.
template <int D>
bool has_short_cycle(const GroupTable& table, const Subgroup& group, const Subgroup& sublattice,
                     const std::vector<CellPoints<D>>& cells);

extern template std::optional<ShortCycle> find_short_cycle<2>(const GroupTable&,
                                                              const std::vector<CellPoints<2>>&);
extern template std::optional<ShortCycle> find_short_cycle<3>(const GroupTable&,
                                                              const std::vector<CellPoints<3>>&);
extern template bool has_short_cycle<2>(const GroupTable&, const Subgroup&, const Subgroup&,
                                        const std::vector<CellPoints<2>>&);
extern template bool has_short_cycle<3>(const GroupTable&, const Subgroup&, const Subgroup&,
                                        const std::vector<CellPoints<3>>&);
extern template std::vector<Element> cycle_translations<2>(const GroupTable&, const Subgroup&,
                                                           const std::vector<CellPoints<2>>&);
extern template std::vector<Element> cycle_translations<3>(const GroupTable&, const Subgroup&,
                                                           const std::vector<CellPoints<3>>&);

}  // namespace flatdt::ref
