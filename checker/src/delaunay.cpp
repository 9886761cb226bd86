// The condition delaunay.empty.   Source: DESIGN.md, section 6 (4); docs/soundness.md, section 4.
#include <algorithm>

#include "context.hpp"
#include "flatdt/checker/errors.hpp"
#include "linear.hpp"
#include "ranges.hpp"

namespace flatdt::checker {
namespace {

/// orientation * (-1)^d det of the rows (p_i - q, |p_i - q|^2) in the coordinates of the files, by rationals.
Rational insphere_value(const Context& context, const std::vector<Vec<Rational>>& p, const Vec<Rational>& q) {
  const int d = context.group.dimension;
  Mat<Rational> edges;
  for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) edges[k] = subtract(p[k + 1], p[0]);
  Rational value = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {  // along the last column
    Mat<Rational> rows;
    for (std::size_t i = 0, row = 0; i < p.size(); ++i) {
      if (i != k) rows[row++] = subtract(p[i], q);
    }
    const Rational term = determinant(d, rows) * squared_norm(d, context.instance.metric, subtract(p[k], q));
    value += (k + p.size() - 1) % 2 == 0 ? term : Rational(-term);
  }
  if (d == 3) value = -value;
  return determinant(d, edges) < 0 ? Rational(-value) : value;
}

/// Whether the apex of the second occurrence is inside the ball of the first's cell, if the two are on
/// opposite sides.
bool is_violated(const Context& context, const FacetPair& pair, bool all_opposite) {
  const auto& [a, b] = pair;
  if (!all_opposite) {
    const Sign side = side_of(context, a);
    if (side == Sign::zero || side_of(context, b) != opposite(side)) return false;
  }
  const Complex& complex = context.complex;
  const Cell& cell = complex.cells[index(a.cell)];
  const Cell& other = complex.cells[index(b.cell)];
  // Both cells are moved until the facet is its canonical list.
  const Lift apex{other.vertex[b.facet], complex.offsets(other)[b.base][b.facet]};
  const Sign orientation = orientation_in_frame(context, a.cell, a.base);
  return context.geometry.insphere(cell, a.base, orientation, apex) == Sign::positive;
}

/// The first violated pair, or null.
const FacetPair* first_violation(const Context& context) {
  using enum ConditionName;
  const bool all_opposite = context.has(cells_nondegenerate) && context.has(facets_opposite);
  const std::vector<FacetPair>& pairs = context.faces.pairs;
  std::vector<const FacetPair*> found(context.jobs);  // the first in each range
  in_ranges(pairs.size(), context.jobs, [&](unsigned r, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end && found[r] == nullptr; ++k) {
      fetch_ahead(context, k);
      if (is_violated(context, pairs[k], all_opposite)) found[r] = &pairs[k];
    }
  });
  const auto first =
      std::find_if(found.begin(), found.end(), [](const FacetPair* p) { return p != nullptr; });
  return first == found.end() ? nullptr : *first;
}

}  // namespace

// Both apices of a facet are inside the other's ball or neither is, so one test for each facet is enough.
void check_delaunay(const Context& context) {
  using enum ConditionName;
  if (const FacetPair* violation = first_violation(context)) {
    const auto& [a, b] = *violation;
    const ElementId gluing = file_gluing(context, a, b);
    const int d = context.group.dimension;
    const Vec<Rational> q =
        apply(d, context.group.outer_seitz(context.table[gluing]), cell_points(context, b.cell)[b.facet]);
    const Rational value = insphere_value(context, cell_points(context, a.cell), q);
    if (value <= 0) throw InternalError("the insphere determinant of a witness is not positive");
    context.fails(delaunay_empty, {{"cell", number_text(index(a.cell))},
                                   {"facet", number_text(a.facet)},
                                   {"cell-points", cell_text(context, a.cell)},
                                   {"other-cell", number_text(index(b.cell))},
                                   {"other-facet", number_text(b.facet)},
                                   {"gluing", element_text(context, gluing)},
                                   {"apex", to_string(d, q)},
                                   {"insphere", value.get_str()}});
    return;
  }
  const bool global = context.has(vertices_complete) && context.has(cells_nondegenerate) &&
                      context.has(facets_paired) && context.has(facets_opposite) && context.has(volume_exact);
  if (global) context.holds(delaunay_empty, {{"facets", number_text(context.faces.pairs.size())}});
}

}  // namespace flatdt::checker
