#include "flatdt/ref/skeleton_cycles.hpp"

#include <algorithm>
#include <bit>
#include <utility>

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
  const Subgroup whole = Subgroup::whole(table);
  std::optional<Edge> loop;
  for (const CellPoints<D>& cell : cells)
    for (std::size_t i = 0; i <= D; ++i)
      for (std::size_t j = i + 1; j <= D; ++j) {
        if (cell[i].site != cell[j].site || (loop && (*loop)[0].site < cell[i].site)) continue;
        const Edge e = canonical_face<2>(table, whole, {cell[i], cell[j]}).key;
        if (!loop || e < *loop) loop = e;
      }
  if (loop) {
    const Edge& e = *loop;
    const Element g = table.multiply(table.inverse(e[0].g), e[1].g);
    return ShortCycle{true, e[0].site, e[1].site, g, g};
  }
  const std::vector<Edge> edges = edges_modulo<D>(table, whole, cells);
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

template <int D>
bool has_short_cycle(const GroupTable& table, const Subgroup& group, const Subgroup& sublattice,
                     const std::vector<CellPoints<D>>& cells) {
  // g h^-1 is in S iff g and h are in one right coset of S.
  struct Arrival {
    SiteId from;
    std::uint32_t rep;
    SiteId to;
    std::uint32_t coset;
    bool operator==(const Arrival&) const = default;
  };
  constexpr std::uint32_t kFree = 0xffffffffU;
  std::vector<std::pair<Arrival, Element>> arrivals;
  arrivals.reserve(cells.size() * D * (D + 1));
  // Open addressing, at most half full.
  std::vector<std::uint32_t> slots(std::bit_ceil(2 * cells.size() * D * (D + 1)), kFree);
  for (const CellPoints<D>& cell : cells)
    for (std::size_t i = 0; i <= D; ++i) {
      const Subgroup::Split split = group.split(cell[i].g);
      const Element mover = table.inverse(split.s);
      for (std::size_t j = 0; j <= D; ++j) {
        if (j == i) continue;
        const Element g = table.multiply(mover, cell[j].g);
        const Arrival arrival{cell[i].site, split.rep, cell[j].site, sublattice.split(g).rep};
        if (arrival.from == arrival.to &&
            arrival.coset == sublattice.split(group.representative(split.rep)).rep)
          return true;
        std::uint64_t hash =
            (std::uint64_t{index_of(arrival.from)} << 32U ^ index_of(arrival.to)) + arrival.rep;
        hash = (hash * 0x9e3779b97f4a7c15U ^ arrival.coset) * 0x9e3779b97f4a7c15U;
        for (std::size_t slot = hash >> 32U & (slots.size() - 1);; slot = (slot + 1) & (slots.size() - 1)) {
          if (slots[slot] == kFree) {
            slots[slot] = static_cast<std::uint32_t>(arrivals.size());
            arrivals.emplace_back(arrival, g);
            break;
          }
          const auto& [other, h] = arrivals[slots[slot]];
          if (!(other == arrival)) continue;
          if (h != g) return true;
          break;
        }
      }
    }
  return false;
}

template std::optional<ShortCycle> find_short_cycle<2>(const GroupTable&, const std::vector<CellPoints<2>>&);
template std::optional<ShortCycle> find_short_cycle<3>(const GroupTable&, const std::vector<CellPoints<3>>&);
template bool has_short_cycle<2>(const GroupTable&, const Subgroup&, const Subgroup&,
                                 const std::vector<CellPoints<2>>&);
template bool has_short_cycle<3>(const GroupTable&, const Subgroup&, const Subgroup&,
                                 const std::vector<CellPoints<3>>&);
template std::vector<Element> cycle_translations<2>(const GroupTable&, const Subgroup&,
                                                    const std::vector<CellPoints<2>>&);
template std::vector<Element> cycle_translations<3>(const GroupTable&, const Subgroup&,
                                                    const std::vector<CellPoints<3>>&);

}  // namespace flatdt::ref
