// The conditions that make the cells a tiling: vertices.complete, cells.nondegenerate, facets.paired,
// facets.opposite, volume.exact.   Source: docs/soundness.md, section 3.
#include <algorithm>
#include <utility>

#include "context.hpp"
#include "flatdt/checker/errors.hpp"
#include "linear.hpp"
#include "ranges.hpp"

namespace flatdt::checker {
namespace {

Witness facet_witness(const Context& context, const Occurrence& o) {
  return {{"cell", number_text(index(o.cell))},
          {"facet", number_text(o.facet)},
          {"cell-points", cell_text(context, o.cell)},
          {"facet-vertices", face_text(context, key_of_facet(context.complex, o))}};
}

/// det[p_1 - p_0 .. p_d - p_0] with p_facet replaced by `apex`, in the instance's coordinates.
Rational orientation_with(int d, std::vector<Vec<Rational>> points, std::size_t facet,
                          const Vec<Rational>& apex) {
  points[facet] = apex;
  Mat<Rational> rows;
  for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) rows[k] = subtract(points[k + 1], points[0]);
  return determinant(d, rows);
}

void check_opposite(const Context& context) {
  using enum ConditionName;
  for (const auto& [a, b] : context.faces.pairs) {
    const Sign side = side_of(context, a);
    if (side == Sign::zero || side != side_of(context, b)) continue;
    Witness witness = facet_witness(context, a);
    const int d = context.group.dimension;
    const ElementId gluing = file_gluing(context, a, b);
    const std::vector<Vec<Rational>> points = cell_points(context, a.cell);
    const Vec<Rational> apex =
        apply(d, context.group.outer_seitz(context.table[gluing]), cell_points(context, b.cell)[b.facet]);
    witness.insert(witness.end(),
                   {{"other-cell", number_text(index(b.cell))},
                    {"other-facet", number_text(b.facet)},
                    {"gluing", element_text(context, gluing)},
                    {"other-apex", to_string(d, apex)},
                    {"determinant", orientation_with(d, points, a.facet, points[a.facet]).get_str()},
                    {"other-determinant", orientation_with(d, points, a.facet, apex).get_str()}});
    context.fails(facets_opposite, std::move(witness));
    return;
  }
  context.holds(facets_opposite, {{"facets", number_text(context.faces.pairs.size())}});
}

}  // namespace

void check_vertices(const Context& context) {
  using enum ConditionName;
  const Integer& sheets = context.subgroup.index();
  const Integer expected = sheets * static_cast<unsigned long>(context.orbits.count());
  const std::size_t found = context.complex.vertices.size();
  Witness witness = {{"vertices", number_text(found)},
                     {"expected", expected.get_str()},
                     {"index", sheets.get_str()},
                     {"points", number_text(context.orbits.count())}};
  if (expected < static_cast<unsigned long>(found)) throw InternalError("more vertices than cosets");
  if (expected == static_cast<unsigned long>(found)) {
    context.holds(vertices_complete, std::move(witness));
    return;
  }
  std::vector<std::size_t> copies(context.orbits.count());
  for (const Vertex& v : context.complex.vertices) ++copies[index(v.orbit)];
  for (std::size_t orbit = 0; orbit < copies.size(); ++orbit) {
    if (sheets == static_cast<unsigned long>(copies[orbit])) continue;
    witness.emplace_back("point", number_text(index(context.orbits.first_point[orbit])));
    witness.emplace_back("copies-of-point", number_text(copies[orbit]));
    break;
  }
  context.fails(vertices_complete, std::move(witness));
}

void check_cells(Context& context) {
  using enum ConditionName;
  const std::size_t n = context.complex.cells.size();
  context.orientation.resize(n);
  std::vector<VolumeSum> sums(context.jobs, context.geometry.no_volume());
  in_ranges(n, context.jobs, [&](unsigned r, std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      context.orientation[c] = context.geometry.orientation(context.complex.cells[c], sums[r]);
    }
  });
  VolumeSum& sum = sums.front();
  for (std::size_t r = 1; r < sums.size(); ++r) sum.add(sums[r]);
  std::size_t degenerate = 0;
  while (degenerate < n && context.orientation[degenerate] != Sign::zero) ++degenerate;
  if (degenerate == n) {
    context.holds(cells_nondegenerate, {{"cells", number_text(n)}});
  } else {
    context.fails(cells_nondegenerate, {{"cell", number_text(degenerate)},
                                        {"cell-points", cell_text(context, make_id<CellId>(degenerate))},
                                        {"determinant", "0"}});
  }
  // In the instance's coordinates a unit cell of G's lattice has volume |det basis|; a simplex 1/d! of its
  // determinant.
  const int d = context.group.dimension;
  const Rational unit = abs(determinant(d, context.group.basis));
  const Rational volume = sum.total() / (d == 2 ? 2 : 6);
  const Rational& expected = context.subgroup.volume();
  Witness witness = {{"volume-of-cells", number_text(volume * unit)},
                     {"expected", number_text(expected * unit)}};
  if (volume == expected) {
    context.holds(volume_exact, std::move(witness));
  } else {
    witness.emplace_back("cells-are", volume < expected ? "too-little" : "too-much");
    context.fails(volume_exact, std::move(witness));
  }
}

void check_facets(const Context& context) {
  using enum ConditionName;
  if (!context.faces.flattened.empty()) {
    const CellId cell = context.faces.flattened.front();
    context.fails(facets_paired, {{"reason", "cell-with-repeated-vertex"},
                                  {"cell", number_text(index(cell))},
                                  {"cell-points", cell_text(context, cell)}});
  } else if (context.faces.odd) {
    Witness witness = facet_witness(context, context.faces.odd->first);
    witness.emplace_back("occurrences", number_text(context.faces.odd->occurrences));
    context.fails(facets_paired, std::move(witness));
  } else {
    context.holds(facets_paired, {{"facets", number_text(context.faces.pairs.size())}});
  }
  check_opposite(context);
}

// Moving the normalised cell by offset[0][base]^-1 multiplies its orientation by the determinant of the
// linear part.
Sign orientation_in_frame(const Context& context, CellId cell, std::size_t base) {
  const Sign orientation = context.orientation[index(cell)];
  return context.complex.reverses(context.complex.cells[index(cell)], base) ? opposite(orientation)
                                                                            : orientation;
}

// In the order of the cell's corners the orientation is that of the moved cell; bringing (facet, apex) into
// that order has the occurrence's parity.
Sign side_of(const Context& context, const Occurrence& occurrence) {
  const Sign orientation = orientation_in_frame(context, occurrence.cell, occurrence.base);
  return occurrence.parity < 0 ? opposite(orientation) : orientation;
}

}  // namespace flatdt::checker
