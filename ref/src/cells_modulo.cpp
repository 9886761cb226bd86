#include "flatdt/ref/cells_modulo.hpp"

#include <algorithm>

#include "flatdt/ref/canonical_face.hpp"

namespace flatdt::ref {

template <int D>
std::optional<CellList<D>> cells_modulo(const GroupTable& table, const Subgroup& group, CellList<D> cells,
                                        std::uint32_t multiplicity) {
  using Cell = typename CellList<D>::Cell;
  Records<Cell>& records = cells.cells();
  for (std::size_t i = 0; i < records.size(); ++i) {
    Cell& cell = records[i];
    // Base positions of sites, which are then all different, are canonical once they are sorted.
    if (std::all_of(cell.begin(), cell.end(),
                    [](const auto& corner) { return corner.code == WideElementStore::kIdentity; }))
      std::sort(cell.begin(), cell.end(), [](const auto& a, const auto& b) { return a.site < b.site; });
    else
      cells.set(i, canonical_face<D + 1>(table, group, cells[i]).key);
  }
  cells.sort();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < records.size();) {
    std::size_t end = i;
    while (end < records.size() && records[end] == records[i]) ++end;
    if (end - i != multiplicity) return std::nullopt;
    records[kept++] = records[i];
    i = end;
  }
  records.truncate(kept);
  if (multiplicity > 1) records.shrink_to_fit();
  return cells;
}

template <int D>
std::optional<std::vector<CellPoints<D>>> cells_modulo(const GroupTable& table, const Subgroup& group,
                                                       const std::vector<CellPoints<D>>& cells,
                                                       std::uint32_t multiplicity) {
  const auto list = cells_modulo<D>(table, group, CellList<D>(cells), multiplicity);
  if (!list) return std::nullopt;
  return list->listed();
}

template <int D>
std::vector<CellPoints<D>> unfold(const GroupTable& table, const Subgroup& group, const Subgroup& target,
                                  const std::vector<CellPoints<D>>& cells) {
  std::vector<Element> representatives;
  for (std::uint32_t rep = 0; rep < target.index(); ++rep)
    if (group.split(target.representative(rep)).rep == 0)
      representatives.push_back(target.representative(rep));
  std::vector<CellPoints<D>> result;
  result.reserve(cells.size() * representatives.size());
  for (const CellPoints<D>& cell : cells)
    for (const Element& r : representatives)
      result.push_back(canonical_face<D + 1>(table, target, moved<D + 1>(table, r, cell)).key);
  std::sort(result.begin(), result.end());
  return result;
}

template std::optional<std::vector<CellPoints<2>>> cells_modulo<2>(const GroupTable&, const Subgroup&,
                                                                   const std::vector<CellPoints<2>>&,
                                                                   std::uint32_t);
template std::optional<std::vector<CellPoints<3>>> cells_modulo<3>(const GroupTable&, const Subgroup&,
                                                                   const std::vector<CellPoints<3>>&,
                                                                   std::uint32_t);
template std::optional<CellList<2>> cells_modulo<2>(const GroupTable&, const Subgroup&, CellList<2>,
                                                    std::uint32_t);
template std::optional<CellList<3>> cells_modulo<3>(const GroupTable&, const Subgroup&, CellList<3>,
                                                    std::uint32_t);
template std::vector<CellPoints<2>> unfold<2>(const GroupTable&, const Subgroup&, const Subgroup&,
                                              const std::vector<CellPoints<2>>&);
template std::vector<CellPoints<3>> unfold<3>(const GroupTable&, const Subgroup&, const Subgroup&,
                                              const std::vector<CellPoints<3>>&);

}  // namespace flatdt::ref
