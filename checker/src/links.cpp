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
  explicit Link(const Complex& complex) : complex_(complex) {}

  /// Why the link of a vertex with these corners is no sphere, or null.
  const char* defect(const Corner* first, const Corner* last) {
    number_vertices(first, last);
    return complex_.corners == 3 ? cycle_defect() : sphere_defect();
  }
  /// Of the last link.
  [[nodiscard]] std::size_t vertices() const { return vertices_; }

 private:
  /// The local numbers of the 2 or 3 vertices of a simplex.
  using Simplex = std::array<std::uint32_t, 3>;

  void number_vertices(const Corner* first, const Corner* last) {
    vertices_ = 0;
    simplices_.clear();
    numbers_.reset(static_cast<std::size_t>(last - first));
    for (const Corner* at = first; at != last; ++at) {
      const Cell& cell = complex_.cells[index(at->cell)];
      const std::array<ElementId, 4>& offset = complex_.offsets(cell)[at->corner];
      Simplex simplex{};
      std::size_t k = 0;
      for (std::size_t j = 0; j < complex_.corners; ++j) {
        if (j == at->corner) continue;
        simplex[k] = numbers_.insert(pair_key(cell.vertex[j], offset[j]), vertices_);
        if (simplex[k++] == vertices_) ++vertices_;
      }
      simplices_.push_back(simplex);
    }
  }

  /// A graph is a cycle iff every vertex has degree 2 and it is connected.
  const char* cycle_defect() {
    degree_.assign(vertices_, 0);
    components_.reset(vertices_);
    for (const Simplex& edge : simplices_) {
      ++degree_[edge[0]];
      ++degree_[edge[1]];
      components_.join(edge[0], edge[1]);
    }
    if (std::any_of(degree_.begin(), degree_.end(), [](std::uint32_t n) { return n != 2; })) {
      return "a-vertex-of-the-link-has-not-two-edges";
    }
    return components_.count() == 1 ? nullptr : "the-link-is-not-connected";
  }

  /// A set of triangles is a sphere iff every edge has two triangles, all triangles are connected across
  /// edges, and V - E + F = 2. (Pulled apart at its vertices it is a connected closed surface, of Euler number
  /// at most 2; a vertex at which that surface touches itself lowers the number. So 2 means a sphere that
  /// touches itself nowhere.)
  const char* sphere_defect() {
    edge_numbers_.reset(2 * simplices_.size());
    edges_.clear();
    components_.reset(simplices_.size());
    for (std::uint32_t t = 0; t < simplices_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(simplices_[t][k], simplices_[t][(k + 1) % 3]);
        const auto next = static_cast<std::uint32_t>(edges_.size());
        const std::uint32_t number = edge_numbers_.insert(pair_key(low, high), next);
        if (number == next) {
          edges_.push_back({t, 1});
        } else {
          ++edges_[number].triangles;
          components_.join(edges_[number].first, t);
        }
      }
    }
    // A facet at the vertex; facets.paired leaves other numbers only to cells listed twice.
    if (std::any_of(edges_.begin(), edges_.end(), [](const LinkEdge& e) { return e.triangles != 2; })) {
      return "an-edge-of-the-link-has-not-two-triangles";
    }
    if (components_.count() != 1) return "the-link-is-not-connected";
    return vertices_ + simplices_.size() == edges_.size() + 2 ? nullptr
                                                              : "the-Euler-number-of-the-link-is-not-2";
  }

  struct LinkEdge {
    std::uint32_t first;  // triangle
    std::uint32_t triangles;
  };

  const Complex& complex_;
  std::uint32_t vertices_ = 0;
  std::vector<Simplex> simplices_;
  std::vector<LinkEdge> edges_;
  std::vector<std::uint32_t> degree_;
  IdMap numbers_;       // of vertices
  IdMap edge_numbers_;  // by the numbers of the ends
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
    const char* defect = link.defect(corners.data() + start[v], corners.data() + start[v + 1]);
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
