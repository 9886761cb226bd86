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

/// Is the 1-skeleton modulo `subgroup` free of loops and 2-cycles? `cells` are the cells modulo that
/// subgroup.
template <int D>
bool is_simplicial(const GroupTable& table, const Subgroup& subgroup,
                   const std::vector<CellPoints<D>>& cells);

extern template std::optional<ShortCycle> find_short_cycle<2>(const GroupTable&,
                                                              const std::vector<CellPoints<2>>&);
extern template std::optional<ShortCycle> find_short_cycle<3>(const GroupTable&,
                                                              const std::vector<CellPoints<3>>&);
extern template bool is_simplicial<2>(const GroupTable&, const Subgroup&, const std::vector<CellPoints<2>>&);
extern template bool is_simplicial<3>(const GroupTable&, const Subgroup&, const std::vector<CellPoints<3>>&);

}  // namespace flatdt::ref
