/// The cells of a triangulation of E^d modulo a group, from its cells modulo another.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "flatdt/ref/cell_list.hpp"
#include "flatdt/ref/subgroup.hpp"

namespace flatdt::ref {

/// The cells of E^d modulo a group, given one lift of each cell modulo a subgroup of index `multiplicity` in
/// it: each as its canonical list, sorted. Nothing if the set of cells is not invariant under the group (some
/// cell does not occur exactly `multiplicity` times).
template <int D>
std::optional<std::vector<CellPoints<D>>> cells_modulo(const GroupTable& table, const Subgroup& group,
                                                       const std::vector<CellPoints<D>>& cells,
                                                       std::uint32_t multiplicity);

/// The same in the memory of the list, which becomes the answer.
template <int D>
std::optional<CellList<D>> cells_modulo(const GroupTable& table, const Subgroup& group, CellList<D> cells,
                                        std::uint32_t multiplicity);

/// The cells modulo `target`, a subgroup of `group`, given one lift of each cell modulo `group`: each moved
/// by all coset representatives, as canonical lists, sorted.
template <int D>
std::vector<CellPoints<D>> unfold(const GroupTable& table, const Subgroup& group, const Subgroup& target,
                                  const std::vector<CellPoints<D>>& cells);

extern template std::optional<std::vector<CellPoints<2>>> cells_modulo<2>(const GroupTable&, const Subgroup&,
                                                                          const std::vector<CellPoints<2>>&,
                                                                          std::uint32_t);
extern template std::optional<std::vector<CellPoints<3>>> cells_modulo<3>(const GroupTable&, const Subgroup&,
                                                                          const std::vector<CellPoints<3>>&,
                                                                          std::uint32_t);
extern template std::optional<CellList<2>> cells_modulo<2>(const GroupTable&, const Subgroup&, CellList<2>,
                                                           std::uint32_t);
extern template std::optional<CellList<3>> cells_modulo<3>(const GroupTable&, const Subgroup&, CellList<3>,
                                                           std::uint32_t);
extern template std::vector<CellPoints<2>> unfold<2>(const GroupTable&, const Subgroup&, const Subgroup&,
                                                     const std::vector<CellPoints<2>>&);
extern template std::vector<CellPoints<3>> unfold<3>(const GroupTable&, const Subgroup&, const Subgroup&,
                                                     const std::vector<CellPoints<3>>&);

}  // namespace flatdt::ref
