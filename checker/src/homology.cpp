// The condition topology.homology: H_1 of the face complex, by collapses and a small Smith normal form.
//
// H_1 = Z^edges / (edges of a spanning tree, boundaries of triangles). Reductions that keep it:
//   3D: the boundary of a cell is a relation among its triangles' boundaries, so along a spanning tree of
//   cells and
//       facets the triangle of each tree facet is a consequence of the others and is dropped;
//   an edge that occurs once in one remaining triangle is the sum of that triangle's other edges: both are
//   removed
//       (a collapse); when no such edge is left, a triangle is set aside as a relation and the collapses go
//       on.
// What remains are a graph, of which a spanning forest is zero, and the relations set aside.
// Source: [Forman98]; docs/soundness.md, section 6.
#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "context.hpp"
#include "union_find.hpp"

namespace flatdt::checker {
namespace {

constexpr std::size_t kMaxCells = 200'000;
constexpr std::size_t kMaxCritical = 100;
constexpr std::size_t kMaxTerms = 2'000'000;

/// A side of a triangle: an edge with the sign it has in the boundary.
struct Side {
  std::uint32_t edge;
  int sign;
};
using Triangle = std::array<Side, 3>;
using Chain = std::map<std::uint32_t, Integer>;  // over the remaining edges

class FirstHomology {
 public:
  FirstHomology(std::size_t edges, std::vector<Triangle> triangles)
      : triangles_(std::move(triangles)),
        uses_(edges),
        live_(triangles_.size(), true),
        incident_(edges),
        chain_(edges) {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (const Side& side : triangles_[t]) {
        ++uses_[side.edge];
        incident_[side.edge].push_back(t);
      }
    }
  }

  void drop(std::uint32_t t) {
    live_[t] = false;
    for (const Side& side : triangles_[t]) --uses_[side.edge];
  }

  /// The group, or nothing above the limits. `ends` of an edge are its vertices.
  std::optional<AbelianGroup> compute(const std::vector<Edge>& edges, std::size_t vertices) {
    collapse();
    std::vector<bool> collapsed(edges.size());
    for (const auto& [edge, triangle] : collapses_) collapsed[edge] = true;
    UnionFind forest(vertices);
    std::uint32_t generators = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (collapsed[e] || forest.join(edges[e].low, edges[e].high)) continue;
      chain_[e].emplace(generators++, 1);
    }
    if (generators > kMaxCritical || set_aside_.size() > kMaxCritical) return std::nullopt;
    std::size_t terms = 0;
    for (std::size_t i = collapses_.size();
         i-- > 0;) {  // the sides other than the edge were removed later or remain
      const auto& [edge, t] = collapses_[i];
      const Side own = *std::find_if(triangles_[t].begin(), triangles_[t].end(),
                                     [e = edge](const Side& side) { return side.edge == e; });
      Chain chain;
      for (const Side& side : triangles_[t]) {
        if (side.edge != edge) accumulate(chain, chain_[side.edge], -own.sign * side.sign);
      }
      terms += chain.size();
      if (terms > kMaxTerms) return std::nullopt;
      chain_[edge] = std::move(chain);
    }
    Rows relations;
    for (const std::uint32_t t : set_aside_) {
      Chain boundary;
      for (const Side& side : triangles_[t]) accumulate(boundary, chain_[side.edge], side.sign);
      auto& row = relations.emplace_back(generators);
      for (const auto& [generator, coefficient] : boundary) row[generator] = coefficient;
    }
    return abelian_group(generators, std::move(relations));
  }

 private:
  static void accumulate(Chain& sum, const Chain& chain, int sign) {
    for (const auto& [generator, coefficient] : chain) {
      Integer& entry = sum[generator];
      entry += sign * coefficient;
      if (entry == 0) sum.erase(generator);
    }
  }

  void remove(std::uint32_t t) {
    drop(t);
    for (const Side& side : triangles_[t]) {
      if (uses_[side.edge] == 1) free_.push_back(side.edge);
    }
  }

  void collapse() {
    for (std::uint32_t e = 0; e < uses_.size(); ++e) {
      if (uses_[e] == 1) free_.push_back(e);
    }
    std::uint32_t next = 0;
    for (std::size_t head = 0;;) {
      if (head < free_.size()) {
        const std::uint32_t edge = free_[head++];
        if (uses_[edge] != 1) continue;
        const std::uint32_t t = *std::find_if(incident_[edge].begin(), incident_[edge].end(),
                                              [&](std::uint32_t triangle) { return live_[triangle]; });
        collapses_.emplace_back(edge, t);
        remove(t);
        continue;
      }
      while (next < live_.size() && !live_[next]) ++next;
      if (next == live_.size()) return;
      set_aside_.push_back(next);
      remove(next);
    }
  }

  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> uses_;  // sides of live triangles, by edge
  std::vector<bool> live_;
  std::vector<std::vector<std::uint32_t>> incident_;
  std::vector<Chain> chain_;         // by edge, in terms of the generators
  std::vector<std::uint32_t> free_;  // queue of edges that may have one use
  std::vector<std::pair<std::uint32_t, std::uint32_t>> collapses_;
  std::vector<std::uint32_t> set_aside_;
};

/// The boundary (01) + (12) - (02) of a triangle of a cell, in terms of sorted edges.
Triangle boundary(const Complex& complex, CellId c, const Corners& triangle, const std::vector<Edge>& edges) {
  const Cell& cell = complex.cells[index(c)];
  const Offsets& offset = complex.offsets(cell);
  Triangle sides{};
  for (std::size_t s = 0; s < 3; ++s) {
    Corners ends{triangle[s], triangle[(s + 1) % 3]};
    make_canonical(cell, offset, ends, 2);
    const Edge edge{static_cast<std::uint32_t>(cell.vertex[ends[0]]),
                    static_cast<std::uint32_t>(cell.vertex[ends[1]]),
                    static_cast<std::uint32_t>(offset[ends[0]][ends[1]])};
    sides[s].edge =
        static_cast<std::uint32_t>(std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin());
    sides[s].sign = ends[0] == triangle[s] ? 1 : -1;
  }
  return sides;
}

}  // namespace

void check_homology(const Context& context) {
  using enum ConditionName;
  const Complex& complex = context.complex;
  if (!context.has(facets_paired) || complex.cells.size() > kMaxCells) return;
  const std::vector<Edge>& edges = context.faces.edges;
  const std::vector<FacetPair>& pairs = context.faces.pairs;
  std::vector<Triangle> triangles;  // 3D: one for each pair, in their order
  if (complex.corners == 3) {
    for (const CellId c : context.faces.distinct_cells) {
      Corners triangle{0, 1, 2};
      make_canonical(complex.cells[index(c)], complex.offsets(complex.cells[index(c)]), triangle, 3);
      triangles.push_back(boundary(complex, c, triangle, edges));
    }
  } else {
    for (const auto& [a, b] : pairs) {
      triangles.push_back(boundary(complex, a.cell, facet_corners(complex, a), edges));
    }
  }
  FirstHomology homology(edges.size(), std::move(triangles));
  if (complex.corners == 4) {
    UnionFind tree(complex.cells.size());
    for (std::uint32_t t = 0; t < pairs.size(); ++t) {
      if (tree.join(index(pairs[t].first.cell), index(pairs[t].second.cell))) homology.drop(t);
    }
  }
  const std::optional<AbelianGroup> found = homology.compute(edges, complex.vertices.size());
  if (!found) return;
  const AbelianGroup expected = first_homology(context.subgroup.own());
  Witness witness = {{"complex", to_string(*found)}, {"manifold", to_string(expected)}};
  if (*found == expected) {
    context.holds(topology_homology, std::move(witness));
  } else {
    context.fails(topology_homology, std::move(witness));
  }
}

}  // namespace flatdt::checker
