#include "flatdt/ref/skeleton_cycles.hpp"

#include <algorithm>
#include <tuple>

namespace flatdt::ref {
namespace {

using Edge = std::array<OrbitPoint, 2>;

template <int D>
std::vector<Edge> edges_modulo(const GroupTable& table, const Subgroup& subgroup,
                               const std::vector<CellPoints<D>>& cells) {
  std::vector<Edge> edges;
  edges.reserve(cells.size() * (D * (D + 1) / 2));
  for (const CellPoints<D>& cell : cells)
    for (std::size_t i = 0; i <= D; ++i)
      for (std::size_t j = i + 1; j <= D; ++j)
        edges.push_back(canonical_face<2>(table, subgroup, {cell[i], cell[j]}).key);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

template <int D>
std::optional<ShortCycle> find_short_cycle(const GroupTable& table, const std::vector<CellPoints<D>>& cells) {
  const std::vector<Edge> edges = edges_modulo<D>(table, Subgroup::whole(table), cells);
  for (const Edge& e : edges) {
    if (e[0].site != e[1].site) continue;
    const Element g = table.multiply(table.inverse(e[0].g), e[1].g);
    return ShortCycle{true, e[0].site, e[1].site, g, g};
  }
  // Modulo G a key without a loop starts with the identity at the lesser site, so equal ends are adjacent in
  // the order of keys unless the elements differ: compare sites only.
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge& e = edges[i];
    const Edge& f = edges[i + 1];
    if (e[0].site == f[0].site && e[1].site == f[1].site)
      return ShortCycle{false, e[0].site, e[1].site, e[1].g, f[1].g};
  }
  return std::nullopt;
}

template <int D>
bool is_simplicial(const GroupTable& table, const Subgroup& subgroup,
                   const std::vector<CellPoints<D>>& cells) {
  using Vertex = std::pair<SiteId, std::uint32_t>;
  std::vector<std::pair<Vertex, Vertex>> ends;
  for (const Edge& e : edges_modulo<D>(table, subgroup, cells)) {
    Vertex a{e[0].site, subgroup.split(e[0].g).rep};
    Vertex b{e[1].site, subgroup.split(e[1].g).rep};
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    ends.emplace_back(a, b);
  }
  std::sort(ends.begin(), ends.end());
  return std::adjacent_find(ends.begin(), ends.end()) == ends.end();
}

template std::optional<ShortCycle> find_short_cycle<2>(const GroupTable&, const std::vector<CellPoints<2>>&);
template std::optional<ShortCycle> find_short_cycle<3>(const GroupTable&, const std::vector<CellPoints<3>>&);
template bool is_simplicial<2>(const GroupTable&, const Subgroup&, const std::vector<CellPoints<2>>&);
template bool is_simplicial<3>(const GroupTable&, const Subgroup&, const std::vector<CellPoints<3>>&);

}  // namespace flatdt::ref
