// The condition links.spheres, from lifts: the link of the base lift of a vertex v consists of the faces
// opposite to it in all cells h_i^-1 c, for corners i of cells c at v.   Source: FORMAT.md;
// docs/soundness.md, section 6.
#include <algorithm>
#include <utility>

#include "context.hpp"
#include "union_find.hpp"

namespace flatdt::checker {
namespace {

struct Corner {
  CellId cell;
  std::uint8_t corner;
};

/// One simplex of a link: the local numbers of its 2 or 3 vertices.
using LinkSimplex = std::array<std::uint32_t, 3>;

/// One edge of one triangle of a link.
struct LinkEdge {
  std::uint32_t low;
  std::uint32_t high;
  std::size_t triangle;

  [[nodiscard]] bool joins(const LinkEdge& e) const { return low == e.low && high == e.high; }
};

struct Link {
  std::size_t vertices = 0;
  std::vector<LinkSimplex> simplices;
};

Link make_link(const Complex& complex, const std::vector<Corner>& star) {
  std::vector<std::array<std::uint64_t, 3>> keys;
  std::vector<std::uint64_t> all;
  for (const auto& [c, i] : star) {
    const Cell& cell = complex.cells[index(c)];
    auto& simplex = keys.emplace_back();
    std::size_t k = 0;
    for (std::size_t j = 0; j < complex.corners; ++j) {
      if (j == i) continue;
      simplex[k] = pair_key(cell.vertex[j], cell.offset[i][j]);
      all.push_back(simplex[k++]);
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  Link link;
  link.vertices = all.size();
  for (const auto& simplex : keys) {
    LinkSimplex& local = link.simplices.emplace_back();
    for (std::size_t k = 0; k + 1 < complex.corners; ++k) {
      local[k] =
          static_cast<std::uint32_t>(std::lower_bound(all.begin(), all.end(), simplex[k]) - all.begin());
    }
  }
  return link;
}

/// Why a graph is no cycle, or null: every vertex has degree 2, and it is connected.
const char* cycle_defect(const Link& link) {
  std::vector<std::uint32_t> degree(link.vertices);
  UnionFind components(link.vertices);
  for (const LinkSimplex& edge : link.simplices) {
    ++degree[edge[0]];
    ++degree[edge[1]];
    components.join(edge[0], edge[1]);
  }
  if (std::any_of(degree.begin(), degree.end(), [](std::uint32_t n) { return n != 2; })) {
    return "a-vertex-of-the-link-has-not-two-edges";
  }
  return components.count() == 1 ? nullptr : "the-link-is-not-connected";
}

/// Why a set of triangles is no sphere, or null: every edge has two triangles, all triangles are connected
/// across edges, and V - E + F = 2. (Pulled apart at its vertices it is a connected closed surface, of Euler
/// number at most 2; a vertex at which that surface touches itself lowers the number. So 2 means a sphere
/// that touches itself nowhere.)
const char* sphere_defect(const Link& link) {
  std::vector<LinkEdge> sides;
  for (std::size_t t = 0; t < link.simplices.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(link.simplices[t][k], link.simplices[t][(k + 1) % 3]);
      sides.push_back({low, high, t});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const LinkEdge& a, const LinkEdge& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  UnionFind components(link.simplices.size());
  std::size_t edges = 0;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end, ++edges) {
    while (end < sides.size() && sides[end].joins(sides[i])) ++end;
    // A facet at the vertex; facets.paired leaves other numbers only to cells listed twice.
    if (end - i != 2) return "an-edge-of-the-link-has-not-two-triangles";
    components.join(sides[i].triangle, sides[i + 1].triangle);
  }
  if (components.count() != 1) return "the-link-is-not-connected";
  return link.vertices + link.simplices.size() == edges + 2 ? nullptr
                                                            : "the-Euler-number-of-the-link-is-not-2";
}

}  // namespace

void check_links(const Context& context) {
  using enum ConditionName;
  if (!context.has(facets_paired) || !context.has(cells_nondegenerate)) return;
  const Complex& complex = context.complex;
  std::vector<std::size_t> start(complex.vertices.size() + 1);
  for (const CellId c : context.distinct_cells) {
    for (std::size_t i = 0; i < complex.corners; ++i) ++start[index(complex.cells[index(c)].vertex[i]) + 1];
  }
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) start[v + 1] += start[v];
  std::vector<Corner> corners(start.back());
  std::vector<std::size_t> next(start);
  for (const CellId c : context.distinct_cells) {
    for (std::uint8_t i = 0; i < complex.corners; ++i) {
      corners[next[index(complex.cells[index(c)].vertex[i])]++] = {c, i};
    }
  }
  std::vector<Corner> star;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    star.assign(corners.begin() + static_cast<std::ptrdiff_t>(start[v]),
                corners.begin() + static_cast<std::ptrdiff_t>(start[v + 1]));
    const Link link = make_link(complex, star);
    const char* defect = complex.corners == 3 ? cycle_defect(link) : sphere_defect(link);
    if (defect == nullptr) continue;
    context.fails(links_spheres, {{"vertex", lift_text(context, make_id<VertexId>(v), kIdentity)},
                                  {"reason", defect},
                                  {"cells-at-vertex", number_text(star.size())},
                                  {"vertices-of-link", number_text(link.vertices)}});
    return;
  }
  context.holds(links_spheres, {{"links", number_text(complex.vertices.size())}});
}

}  // namespace flatdt::checker
