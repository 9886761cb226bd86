// The conditions on simplices and the 1-skeleton: simplices.injective, skeleton.no-loop, skeleton.no-2-cycle
// and complex.intersection.   Source: Definitions 1 (ii) and 3 and Theorem 7 of Caroli & Teillaud.
#include "context.hpp"

namespace flatdt::checker {

void check_simplices(const Context& context) {
  using enum ConditionName;
  const Complex& complex = context.complex;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const Cell& cell = complex.cells[c];
    const Offsets& offset = complex.offsets(cell);
    for (std::size_t i = 0; i < complex.corners; ++i) {
      for (std::size_t j = i + 1; j < complex.corners; ++j) {
        if (cell.vertex[i] != cell.vertex[j] || offset[i][j] == kIdentity) continue;
        // offset[0][j] offset[0][i]^-1 takes corner i to corner j of the normalised cell; conjugated by the
        // anchor.
        ElementTable& table = context.table;
        const ElementId to_i = table.product(cell.anchor, offset[0][i]);
        const ElementId to_j = table.product(cell.anchor, offset[0][j]);
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
  const std::vector<Edge>& edges = context.faces.edges;
  const Witness size = {{"vertices", number_text(context.complex.vertices.size())},
                        {"edges", number_text(edges.size())}};
  context.holds(skeleton_no_loop, size);
  context.holds(skeleton_no_2_cycle, size);
  // Edges with the same ends are neighbours in the order of the lists.
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (edges[k].low == edges[k].high && context.has(skeleton_no_loop)) {
      context.fails(skeleton_no_loop, {{"edge", face_text(context, edges[k].key())}});
    }
    const bool parallel = k > 0 && edges[k - 1].low == edges[k].low && edges[k - 1].high == edges[k].high;
    if (parallel && context.has(skeleton_no_2_cycle)) {
      context.fails(skeleton_no_2_cycle, {{"edge", face_text(context, edges[k - 1].key())},
                                          {"other-edge", face_text(context, edges[k].key())}});
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
  // Cells have two edges with the same ends if they have the same vertices.   Source: docs/soundness.md,
  // section 6.
  for (std::size_t size = 2; size < context.complex.corners; ++size) {
    const std::optional<Faces::Parallel>& found = context.faces.parallel[size];
    if (!found) continue;
    context.fails(complex_intersection, {{"face", face_text(context, found->front())},
                                         {"other-face", face_text(context, found->back())}});
    return;
  }
  context.holds(complex_intersection);
}

}  // namespace flatdt::checker
