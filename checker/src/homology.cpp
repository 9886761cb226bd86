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
constexpr std::size_t kMaxTerms = 2'000'000;  // of one limb of 64 bits; longer ones count as several
constexpr std::size_t kMaxBits = 100'000;     // of the relations; diagonalising makes numbers grow

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
      : triangles_(std::move(triangles)), uses_(edges), live_(triangles_.size(), true), chain_(edges) {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (const Side& side : triangles_[t]) {
        ++uses_[side.edge].count;
        uses_[side.edge].triangles ^= t;
      }
    }
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
      for (const auto& [generator, coefficient] : chain) terms += mpz_size(coefficient.get_mpz_t());
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
    if (bits_of(relations) > kMaxBits) return std::nullopt;
    return abelian_group(generators, std::move(relations));
  }

 private:
  static std::size_t bits_of(const Rows& rows) {
    std::size_t bits = 0;
    for (const std::vector<Integer>& row : rows) {
      for (const Integer& x : row) bits += x == 0 ? 0 : mpz_sizeinbase(x.get_mpz_t(), 2);
    }
    return bits;
  }

  static void accumulate(Chain& sum, const Chain& chain, int sign) {
    for (const auto& [generator, coefficient] : chain) {
      Integer& entry = sum[generator];
      entry += sign * coefficient;
      if (entry == 0) sum.erase(generator);
    }
  }

  /// The sides of live triangles that are an edge: their number, and the exclusive or of the numbers of their
  /// triangles, which is the triangle itself if there is one side.
  struct Uses {
    std::uint32_t count = 0;
    std::uint32_t triangles = 0;
  };

  void remove(std::uint32_t t) {
    live_[t] = false;
    for (const Side& side : triangles_[t]) {
      --uses_[side.edge].count;
      uses_[side.edge].triangles ^= t;
    }
    for (const Side& side : triangles_[t]) {
      if (uses_[side.edge].count == 1) free_.push_back(side.edge);
    }
  }

  void collapse() {
    for (std::uint32_t e = 0; e < uses_.size(); ++e) {
      if (uses_[e].count == 1) free_.push_back(e);
    }
    std::uint32_t next = 0;
    for (std::size_t head = 0;;) {
      if (head < free_.size()) {
        const std::uint32_t edge = free_[head++];
        if (uses_[edge].count != 1) continue;
        const std::uint32_t t = uses_[edge].triangles;
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
  std::vector<Uses> uses_;  // by edge
  std::vector<bool> live_;
  std::vector<Chain> chain_;         // by edge, in terms of the generators
  std::vector<std::uint32_t> free_;  // queue of edges that may have one use
  std::vector<std::pair<std::uint32_t, std::uint32_t>> collapses_;
  std::vector<std::uint32_t> set_aside_;
};

/// The numbers of the edges, by their lists.
class EdgeNumbers {
 public:
  EdgeNumbers(const std::vector<Edge>& edges, std::size_t vertices) : edges_(edges), end_(vertices) {
    for (std::uint32_t e = 0; e < edges.size(); ++e) end_[edges[e].low] = e + 1;
    for (std::size_t v = 1; v < vertices; ++v) end_[v] = std::max(end_[v], end_[v - 1]);
  }
  [[nodiscard]] std::uint32_t operator()(const Edge& edge) const {
    const auto begin = edges_.begin() + (edge.low == 0 ? 0 : end_[edge.low - 1]);
    const auto at = std::lower_bound(begin, edges_.begin() + end_[edge.low], edge);
    return static_cast<std::uint32_t>(at - edges_.begin());
  }

 private:
  const std::vector<Edge>& edges_;
  std::vector<std::uint32_t> end_;  // by low vertex: after its last edge
};

/// The boundary (01) + (12) - (02) of a triangle of a cell.
Triangle boundary(const Complex& complex, CellId c, const Corners& triangle, const EdgeNumbers& edges) {
  const Cell& cell = complex.cells[index(c)];
  const Offsets& offset = complex.offsets(cell);
  Triangle sides{};
  for (std::size_t s = 0; s < 3; ++s) {
    Corners ends{triangle[s], triangle[(s + 1) % 3]};
    make_canonical(cell, offset, ends, 2);
    sides[s].edge = edges({static_cast<std::uint32_t>(cell.vertex[ends[0]]),
                           static_cast<std::uint32_t>(cell.vertex[ends[1]]),
                           static_cast<std::uint32_t>(offset[ends[0]][ends[1]])});
    sides[s].sign = ends[0] == triangle[s] ? 1 : -1;
  }
  return sides;
}

/// The triangles whose boundaries generate all: in 3D those of the facets that are not in a spanning tree of
/// the cells.
std::vector<Triangle> generating_triangles(const Context& context) {
  const Complex& complex = context.complex;
  const EdgeNumbers edges(context.faces.edges, complex.vertices.size());
  std::vector<Triangle> triangles;
  if (complex.corners == 3) {
    const std::vector<CellId>& repeated = context.faces.repeated_cells;
    for (std::size_t c = 0; c < complex.cells.size(); ++c) {
      if (std::binary_search(repeated.begin(), repeated.end(), make_id<CellId>(c))) continue;
      Corners triangle{0, 1, 2};
      make_canonical(complex.cells[c], complex.offsets(complex.cells[c]), triangle, 3);
      triangles.push_back(boundary(complex, make_id<CellId>(c), triangle, edges));
    }
  } else {
    UnionFind tree(complex.cells.size());
    for (const auto& [a, b] : context.faces.pairs) {
      if (tree.join(index(a.cell), index(b.cell))) continue;
      triangles.push_back(boundary(complex, a.cell, facet_corners(complex, a), edges));
    }
  }
  return triangles;
}

}  // namespace

void check_homology(const Context& context) {
  using enum ConditionName;
  const Complex& complex = context.complex;
  if (!context.has(facets_paired) || complex.cells.size() > kMaxCells) return;
  const std::vector<Edge>& edges = context.faces.edges;
  FirstHomology homology(edges.size(), generating_triangles(context));
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
