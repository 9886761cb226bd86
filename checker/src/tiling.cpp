// The conditions that make the cells a tiling: vertices.complete, cells.nondegenerate, facets.paired,
// facets.opposite, volume.exact.   Source: docs/soundness.md, section 3.
#include <algorithm>
#include <map>
#include <utility>

#include "context.hpp"
#include "flatdt/checker/errors.hpp"
#include "linear.hpp"

namespace flatdt::checker {
namespace {

/// Adds fractions of equal denominator first and then in a balanced tree, so that the work is quasi-linear in
/// the bits even when all denominators differ; a running sum would be quadratic. The tree keeps the order of
/// arrival: cells that are neighbours in the file often share vertices, and then their denominators share
/// factors.
class FractionSum {
 public:
  void add(const Integer& numerator, const Integer& denominator) {
    if (last_ == terms_.size() || terms_[last_].denominator != denominator) {
      const auto [position, inserted] = by_denominator_.try_emplace(denominator, terms_.size());
      if (inserted) terms_.push_back({0, denominator});
      last_ = position->second;
    }
    terms_[last_].numerator += numerator;
  }

  [[nodiscard]] Rational total() const {
    std::vector<Rational> sums;
    for (const Term& term : terms_) {
      sums.emplace_back(term.numerator, term.denominator);
      sums.back().canonicalize();
    }
    for (; sums.size() > 1; sums.resize((sums.size() + 1) / 2)) {
      for (std::size_t i = 0; 2 * i < sums.size(); ++i) {
        if (2 * i + 1 < sums.size()) {
          sums[i] = sums[2 * i] + sums[2 * i + 1];
        } else {
          sums[i] = sums[2 * i];
        }
      }
    }
    return sums.empty() ? Rational(0) : sums.front();
  }

 private:
  struct Term {
    Integer numerator;
    Integer denominator;
  };
  std::vector<Term> terms_;
  std::map<Integer, std::size_t> by_denominator_;
  std::size_t last_ = 0;
};

Witness facet_witness(const Context& context, const Occurrence& o) {
  return {{"cell", number_text(index(o.cell))},
          {"facet", number_text(o.facet)},
          {"cell-points", cell_text(context, o.cell)},
          {"facet-vertices", face_text(context, o.key)}};
}

/// det[p_1 - p_0 .. p_d - p_0] with p_facet replaced by `apex`, in the instance's coordinates.
Rational orientation_with(int d, std::vector<Vec<Rational>> points, std::size_t facet,
                          const Vec<Rational>& apex) {
  points[facet] = apex;
  Mat<Rational> rows;
  for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) rows[k] = subtract(points[k + 1], points[0]);
  return determinant(d, rows);
}

void check_opposite(Context& context) {
  using enum ConditionName;
  for (const FacetPair& pair : context.pairs) {
    const Occurrence& a = context.occurrences[pair.first];
    const Occurrence& b = context.occurrences[pair.second];
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
  context.holds(facets_opposite, {{"facets", number_text(context.pairs.size())}});
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
  FractionSum sum;
  context.orientation.resize(n);
  std::size_t degenerate = n;
  for (std::size_t c = 0; c < n; ++c) {
    const Geometry::Fraction det = context.geometry.determinant(context.complex.cells[c]);
    context.orientation[c] = sign_of(det.numerator);
    if (context.orientation[c] == Sign::zero && degenerate == n) degenerate = c;
    sum.add(abs(det.numerator), det.denominator);
  }
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

void check_facets(Context& context) {
  using enum ConditionName;
  const auto& cells = context.complex.cells;
  context.occurrences = facet_occurrences(context.complex);
  const std::vector<Occurrence>& all = context.occurrences;
  bool paired = true;
  for (std::size_t c = 0; c < cells.size() && paired; ++c) {
    if (!has_repeated_vertex(cells[c], context.complex.corners)) continue;
    paired = false;
    context.fails(facets_paired, {{"reason", "cell-with-repeated-vertex"},
                                  {"cell", number_text(c)},
                                  {"cell-points", cell_text(context, make_id<CellId>(c))}});
  }
  for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
    while (end < all.size() && all[end].key == all[i].key) ++end;
    if (end - i == 2) {
      context.pairs.push_back({i, i + 1});
    } else if (paired) {
      paired = false;
      Witness witness = facet_witness(context, all[i]);
      witness.emplace_back("occurrences", number_text(end - i));
      context.fails(facets_paired, std::move(witness));
    }
  }
  if (paired) context.holds(facets_paired, {{"facets", number_text(context.pairs.size())}});
  check_opposite(context);
}

// Moving the normalised cell by offset[0][base]^-1 multiplies its orientation by the determinant of the
// linear part.
Sign side_of(const Context& context, const Occurrence& occurrence) {
  const Cell& cell = context.complex.cells[index(occurrence.cell)];
  const Sign orientation = context.orientation[index(occurrence.cell)];
  const std::uint8_t rotation = context.table[cell.offset[0][occurrence.base]].rotation;
  const bool reverses = context.group.reversing[rotation];
  return (occurrence.parity < 0) == reverses ? orientation : opposite(orientation);
}

}  // namespace flatdt::checker
