// The conditions on simplices and the 1-skeleton: simplices.injective, skeleton.no-loop, skeleton.no-2-cycle
// and complex.intersection.   Source: Definitions 1 (ii) and 3 and Theorem 7 of Caroli & Teillaud.
#include <algorithm>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/range/iterator_range.hpp>
#include <utility>

#include "context.hpp"

namespace flatdt::checker {
namespace {

using Skeleton = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                    boost::no_property, std::uint32_t, std::size_t>;

/// The 1-skeleton modulo H; edge k of the graph is edges[k], directed from its first vertex, which is the
/// least.
Skeleton make_skeleton(const std::vector<FaceKey>& edges, std::size_t vertices) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  ends.reserve(edges.size());
  for (const FaceKey& edge : edges) ends.emplace_back(edge.vertex[0], edge.vertex[1]);
  return {boost::edges_are_sorted, ends.begin(), ends.end(), static_cast<std::uint32_t>(vertices)};
}

/// A pair of different faces with equal vertices among faces sorted by key, or the end.
std::vector<FaceKey>::const_iterator equal_vertices(const std::vector<FaceKey>& faces) {
  return std::adjacent_find(faces.begin(), faces.end(),
                            [](const FaceKey& a, const FaceKey& b) { return a.vertex == b.vertex; });
}

}  // namespace

void check_simplices(const Context& context) {
  using enum ConditionName;
  const Complex& complex = context.complex;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const Cell& cell = complex.cells[c];
    for (std::size_t i = 0; i < complex.corners; ++i) {
      for (std::size_t j = i + 1; j < complex.corners; ++j) {
        if (cell.vertex[i] != cell.vertex[j] || cell.offset[i][j] == kIdentity) continue;
        // offset[0][j] offset[0][i]^-1 takes corner i to corner j of the normalised cell; conjugated by the
        // anchor.
        ElementTable& table = context.table;
        const ElementId to_i = table.product(cell.anchor, cell.offset[0][i]);
        const ElementId to_j = table.product(cell.anchor, cell.offset[0][j]);
        context.fails(simplices_injective,
                      {{"cell", number_text(c)},
                       {"corners", number_text(i) + "," + number_text(j)},
                       {"cell-points", cell_text(context, make_id<CellId>(c))},
                       {"element", element_text(context, table.product(to_j, table.inverse(to_i)))}});
        return;
      }
    }
  }
  context.holds(simplices_injective);
}

void check_skeleton(const Context& context) {
  using enum ConditionName;
  const std::vector<FaceKey>& edges = context.faces[2];
  const Skeleton skeleton = make_skeleton(edges, context.complex.vertices.size());
  const Witness size = {{"vertices", number_text(num_vertices(skeleton))},
                        {"edges", number_text(edges.size())}};
  context.holds(skeleton_no_loop, size);
  context.holds(skeleton_no_2_cycle, size);
  std::size_t number = 0;  // of the graph's edge e in `edges`
  for (const auto v : boost::make_iterator_range(boost::vertices(skeleton))) {
    std::size_t previous = edges.size();
    for (const auto e : boost::make_iterator_range(out_edges(v, skeleton))) {
      if (target(e, skeleton) == v && context.has(skeleton_no_loop)) {
        context.fails(skeleton_no_loop, {{"edge", face_text(context, edges[number])}});
      }
      const bool parallel = previous < number && edges[previous].vertex[1] == target(e, skeleton);
      if (parallel && context.has(skeleton_no_2_cycle)) {
        context.fails(skeleton_no_2_cycle, {{"edge", face_text(context, edges[previous])},
                                            {"other-edge", face_text(context, edges[number])}});
      }
      previous = number++;
    }
  }
}

void check_intersection(const Context& context) {
  using enum ConditionName;
  if (!context.has(cells_nondegenerate) || !context.has(facets_paired) || !context.has(facets_opposite) ||
      !context.has(volume_exact)) {
    return;
  }
  if (!context.has(simplices_injective)) {
    context.fails(complex_intersection, {{"reason", "simplices.injective-fails"}});
    return;
  }
  for (std::size_t size = 2; size <= context.complex.corners; ++size) {
    const std::vector<FaceKey>& faces = context.faces[size];
    const auto found = equal_vertices(faces);
    if (found == faces.end()) continue;
    context.fails(complex_intersection,
                  {{"face", face_text(context, *found)}, {"other-face", face_text(context, *(found + 1))}});
    return;
  }
  context.holds(complex_intersection);
}

}  // namespace flatdt::checker
