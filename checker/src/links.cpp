// The condition links.spheres, from lifts: the link of the base lift of a vertex v consists of the faces
// opposite to it in all cells h_i^-1 c, for corners i of cells c at v.   Source: FORMAT.md;
// docs/soundness.md, section 6.
#include <algorithm>
#include <utility>

#include "context.hpp"
#include "id_map.hpp"
#include "union_find.hpp"

namespace flatdt::checker {
namespace {

struct Corner {
  CellId cell;
  std::uint8_t corner;
};

/// The link of one vertex after another; its memory is kept.
class Link {
 public:
  explicit Link(const Complex& complex) : complex_(complex), seen_(complex.vertices.size()) {}

  /// Why the link of a vertex with these corners is no sphere, or null.   Requires: no earlier call had this
  /// vertex.
  const char* defect(VertexId vertex, const Corner* first, const Corner* last) {
    number_vertices(vertex, first, last);
    return complex_.corners == 3 ? cycle_defect() : sphere_defect();
  }
  /// Of the last link.
  [[nodiscard]] std::size_t vertices() const { return vertices_; }

 private:
  /// The local numbers of the 2 or 3 vertices of a simplex.
  using Simplex = std::array<std::uint32_t, 3>;

  /// The first lift of a vertex modulo H that is seen in a link.
  struct Seen {
    std::uint32_t link = kNone;  // whose vertex
    ElementId offset{};
    std::uint32_t number = 0;
  };

  /// The local number of a lift, in the link of `vertex`; few vertices modulo H have two lifts in one link.
  std::uint32_t number(VertexId vertex, VertexId v, ElementId offset) {
    Seen& seen = seen_[index(v)];
    if (seen.link != static_cast<std::uint32_t>(vertex)) {
      seen = {static_cast<std::uint32_t>(vertex), offset, vertices_};
    } else if (seen.offset == offset) {
      return seen.number;
    } else if (const std::uint32_t known = others_.insert(pair_key(v, offset), vertices_);
               known != vertices_) {
      return known;
    }
    return vertices_++;
  }

  void number_vertices(VertexId vertex, const Corner* first, const Corner* last) {
    vertices_ = 0;
    simplices_.clear();
    others_.clear();
    for (const Corner* at = first; at != last; ++at) {
      const Cell& cell = complex_.cells[index(at->cell)];
      const std::array<ElementId, 4>& offset = complex_.offsets(cell)[at->corner];
      Simplex simplex{};
      std::size_t k = 0;
      for (std::size_t j = 0; j < complex_.corners; ++j) {
        if (j != at->corner) simplex[k++] = number(vertex, cell.vertex[j], offset[j]);
      }
      simplices_.push_back(simplex);
    }
  }

  /// A graph is a cycle iff every vertex has degree 2 and it is connected.
  const char* cycle_defect() {
    std::vector<std::uint32_t>& degree = start_;
    degree.assign(vertices_, 0);
    components_.reset(vertices_);
    for (const Simplex& edge : simplices_) {
      ++degree[edge[0]];
      ++degree[edge[1]];
      components_.join(edge[0], edge[1]);
    }
    if (std::any_of(degree.begin(), degree.end(), [](std::uint32_t n) { return n != 2; })) {
      return "a-vertex-of-the-link-has-not-two-edges";
    }
    return components_.count() == 1 ? nullptr : "the-link-is-not-connected";
  }

  /// A side of a triangle, stored with the lower of its ends.
  struct Side {
    std::uint32_t high;
    std::uint32_t triangle;
  };
  /// The sides met so far of the edge from the present low end to some high end.
  struct LinkEdge {
    std::uint32_t low = kNone;
    std::uint32_t triangles = 0;
    std::uint32_t first = 0;
  };

  /// Sorts the sides of all triangles by their lower ends: those of end v are sides_[start_[v]..start_[v+1]).
  void sort_sides() {
    start_.assign(vertices_ + 1, 0);
    for (const Simplex& t : simplices_) {
      for (std::size_t k = 0; k < 3; ++k) ++start_[std::min(t[k], t[(k + 1) % 3])];
    }
    std::uint32_t end = 0;
    for (std::uint32_t& s : start_) end = s += end;
    sides_.resize(end);
    for (std::uint32_t t = 0; t < simplices_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(simplices_[t][k], simplices_[t][(k + 1) % 3]);
        sides_[--start_[low]] = {high, t};
      }
    }
  }

  /// A set of triangles is a sphere iff every edge has two triangles, all triangles are connected across
  /// edges, and V - E + F = 2. (Pulled apart at its vertices it is a connected closed surface, of Euler
  /// number at most 2; a vertex at which that surface touches itself lowers the number. So 2 means a sphere
  /// that touches itself nowhere.)
  const char* sphere_defect() {
    sort_sides();
    edges_.assign(vertices_, LinkEdge{});
    components_.reset(simplices_.size());
    std::size_t edges = 0;
    std::size_t complete = 0;
    for (std::uint32_t low = 0; low < vertices_; ++low) {
      for (std::uint32_t i = start_[low]; i < start_[low + 1]; ++i) {
        const auto& [high, triangle] = sides_[i];
        LinkEdge& edge = edges_[high];
        if (edge.low != low) {
          edge = {low, 1, triangle};
          ++edges;
        } else {
          complete += ++edge.triangles == 2 ? 1 : 0;
          components_.join(edge.first, triangle);
        }
      }
    }
    // A facet at the vertex; facets.paired leaves other numbers only to cells listed twice.
    if (complete != edges || sides_.size() != 2 * edges) return "an-edge-of-the-link-has-not-two-triangles";
    if (components_.count() != 1) return "the-link-is-not-connected";
    return vertices_ + simplices_.size() == edges + 2 ? nullptr : "the-Euler-number-of-the-link-is-not-2";
  }

  const Complex& complex_;
  std::vector<Seen> seen_;  // by VertexId
  IdMap others_;            // the lifts that are not in seen_
  std::uint32_t vertices_ = 0;
  std::vector<Simplex> simplices_;
  std::vector<std::uint32_t> start_;
  std::vector<Side> sides_;
  std::vector<LinkEdge> edges_;  // by high end
  UnionFind components_{0};
};

}  // namespace

void check_links(const Context& context) {
  using enum ConditionName;
  if (!context.has(facets_paired) || !context.has(cells_nondegenerate)) return;
  const Complex& complex = context.complex;
  std::vector<std::size_t> start(complex.vertices.size() + 1);
  for (const CellId c : context.faces.distinct_cells) {
    for (std::size_t i = 0; i < complex.corners; ++i) ++start[index(complex.cells[index(c)].vertex[i]) + 1];
  }
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) start[v + 1] += start[v];
  std::vector<Corner> corners(start.back());
  std::vector<std::size_t> next(start);
  for (const CellId c : context.faces.distinct_cells) {
    for (std::uint8_t i = 0; i < complex.corners; ++i) {
      corners[next[index(complex.cells[index(c)].vertex[i])]++] = {c, i};
    }
  }
  Link link(complex);
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    const char* defect =
        link.defect(make_id<VertexId>(v), corners.data() + start[v], corners.data() + start[v + 1]);
    if (defect == nullptr) continue;
    context.fails(links_spheres, {{"vertex", lift_text(context, make_id<VertexId>(v), kIdentity)},
                                  {"reason", defect},
                                  {"cells-at-vertex", number_text(start[v + 1] - start[v])},
                                  {"vertices-of-link", number_text(link.vertices())}});
    return;
  }
  context.holds(links_spheres, {{"links", number_text(complex.vertices.size())}});
}

}  // namespace flatdt::checker
