#include "flatdt/ref/skeleton_cycles.hpp"

#include <algorithm>
#include <tuple>

namespace flatdt::ref {
namespace {

using Edge = std::array<OrbitPoint, 2>;

/// An edge from a point that is its site's representative modulo a group, seen from it.
struct End {
  SiteId from;
  std::uint32_t rep;
  OrbitPoint to;
  friend auto operator<=>(const End&, const End&) = default;
};

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
std::vector<Element> cycle_translations(const GroupTable& table, const Subgroup& group,
                                        const std::vector<CellPoints<D>>& cells) {
  std::vector<End> ends;
  ends.reserve(cells.size() * D * (D + 1));
  for (const CellPoints<D>& cell : cells)
    for (std::size_t i = 0; i <= D; ++i) {
      const Subgroup::Split split = group.split(cell[i].g);
      const Element mover = table.inverse(split.s);
      for (std::size_t j = 0; j <= D; ++j)
        if (j != i)
          ends.push_back({cell[i].site, split.rep, {cell[j].site, table.multiply(mover, cell[j].g)}});
    }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Element> found;
  const auto note = [&](const Element& g, const Element& h) {
    const Element t = table.multiply(g, table.inverse(h));
    if (t.coset == 0) found.push_back(t);
  };
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const End& e = ends[i];
    if (e.to.site == e.from) note(e.to.g, group.representative(e.rep));
    for (std::size_t j = i + 1;
         j < ends.size() && ends[j].from == e.from && ends[j].rep == e.rep && ends[j].to.site == e.to.site;
         ++j)
      note(ends[j].to.g, e.to.g);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool contains_any(const Subgroup& sublattice, const std::vector<Element>& translations) {
  return std::any_of(translations.begin(), translations.end(),
                     [&](const Element& t) { return sublattice.split(t).rep == 0; });
}

template std::optional<ShortCycle> find_short_cycle<2>(const GroupTable&, const std::vector<CellPoints<2>>&);
template std::optional<ShortCycle> find_short_cycle<3>(const GroupTable&, const std::vector<CellPoints<3>>&);
template std::vector<Element> cycle_translations<2>(const GroupTable&, const Subgroup&,
                                                    const std::vector<CellPoints<2>>&);
template std::vector<Element> cycle_translations<3>(const GroupTable&, const Subgroup&,
                                                    const std::vector<CellPoints<3>>&);

}  // namespace flatdt::ref
