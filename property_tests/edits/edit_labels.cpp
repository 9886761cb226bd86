/// Edits of the names of vertices: points and elements exchanged for others. The lemma on one cell is in
/// edit_cells.cpp.
#include "draft.hpp"
#include "reposition.hpp"

namespace flatdt::edits {

using Name = checker::ConditionName;
using ref::Isometry;
using ref::Rational;
using ref::Vector;

namespace {

/// The files, if the cell of that number is now another one modulo H.
std::optional<Files> changed_cell(const Base& base, const Draft& draft, std::size_t c) {
  const std::vector<Vector> now = positions(draft.data(), draft.data().triangulation.cells[c]);
  if (face_key(base.subgroup(), now) == face_key(base.subgroup(), base.cell(c))) return std::nullopt;
  return draft.files();
}

std::optional<Files> other_point(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t c = random.below(base.cell_count());
  draft.cells()[c][random.below(base.corners())].point =
      static_cast<std::uint32_t>(random.below(base.instance().points.size()));
  return changed_cell(base, draft, c);
}

std::optional<Files> other_element(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t c = random.below(base.cell_count());
  draft.cells()[c][random.below(base.corners())].element =
      static_cast<std::uint32_t>(random.below(base.triangulation().elements.size()));
  return changed_cell(base, draft, c);
}

std::optional<Files> other_offset(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t c = random.below(base.cell_count());
  FileVertex& v = draft.cells()[c][random.below(base.corners())];
  Vector offset(base.dimension());
  while (offset.is_zero()) offset = base.group().translation(random, 1).translation;
  v = draft.moved(Isometry::translate(offset), v);
  return changed_cell(base, draft, c);
}

std::optional<Files> wrong_coset(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t c = random.below(base.cell_count());
  FileVertex& v = draft.cells()[c][random.below(base.corners())];
  const Isometry g = base.group().element(random, 1);
  if (base.subgroup().contains(g)) return std::nullopt;
  v = draft.moved(g, v);
  return changed_cell(base, draft, c);
}

std::optional<Files> wrong_gluing(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t c = random.below(base.cell_count());
  const std::size_t apex = random.below(base.corners());
  const Isometry h = base.subgroup().element(random, 1);
  for (std::size_t i = 0; i < base.corners(); ++i)
    if (i != apex) draft.cells()[c][i] = draft.moved(h, draft.cells()[c][i]);
  return changed_cell(base, draft, c);
}

/// The files, if some facet is no longer paired.
std::optional<Files> unpaired(const Base& base, const Draft& draft) {
  return facets_are_paired(draft.data(), base.subgroup()) ? std::nullopt : std::optional(draft.files());
}

std::optional<Files> inverted_elements(const Base& base, Random& /*random*/) {
  Draft draft(base);
  for (Isometry& g : draft.triangulation().elements) g = g.inverse();
  return unpaired(base, draft);
}

std::optional<Files> listed_element_changed(const Base& base, Random& random) {
  Draft draft(base);
  Isometry& g = draft.triangulation().elements[random.below(base.triangulation().elements.size())];
  g = base.group().element(random, 1) * g;
  return unpaired(base, draft);
}

std::optional<Files> two_elements_exchanged(const Base& base, Random& random) {
  Draft draft(base);
  std::vector<Isometry>& elements = draft.triangulation().elements;
  const std::vector<std::size_t> order = random.order(elements.size());
  if (order.size() < 2) return std::nullopt;
  std::swap(elements[order[0]], elements[order[1]]);
  return unpaired(base, draft);
}

std::optional<Files> two_points_exchanged(const Base& base, Random& random) {
  if (!base.points_are_distinct() || base.instance().points.size() < 2) return std::nullopt;
  Draft draft(base);
  const std::vector<std::size_t> order = random.order(base.instance().points.size());
  for (FileCell& cell : draft.cells())
    for (std::size_t i = 0; i < base.corners(); ++i) {
      if (cell[i].point == order[0])
        cell[i].point = static_cast<std::uint32_t>(order[1]);
      else if (cell[i].point == order[1])
        cell[i].point = static_cast<std::uint32_t>(order[0]);
    }
  Case judged = base.valid();
  std::swap(judged.instance.points[order[0]], judged.instance.points[order[1]]);
  if (repositioned(base, judged) == Repositioned::valid) return std::nullopt;
  return draft.files();
}

/// Every vertex g p becomes g t p, for one point p: as if t p stood for p in the cells only.
std::optional<Files> point_shifted_in_cells(const Base& base, Random& random) {
  if (!base.points_are_distinct()) return std::nullopt;
  Draft draft(base);
  const std::size_t point = random.below(base.instance().points.size());
  const Isometry t = base.group().element(random, 1);
  for (FileCell& cell : draft.cells())
    for (std::size_t i = 0; i < base.corners(); ++i)
      if (cell[i].point == point) cell[i].element = draft.index_of(draft.element(cell[i]) * t);
  Case judged = base.valid();
  judged.instance.points[point] = t * judged.instance.points[point];
  if (repositioned(base, judged) == Repositioned::valid) return std::nullopt;
  return draft.files();
}

std::optional<Files> points_merged(const Base& base, Random& random) {
  if (!base.points_are_distinct() || base.instance().points.size() < 2) return std::nullopt;
  Draft draft(base);
  const std::vector<std::size_t> order = random.order(base.instance().points.size());
  for (FileCell& cell : draft.cells())
    for (std::size_t i = 0; i < base.corners(); ++i)
      if (cell[i].point == order[0]) cell[i].point = static_cast<std::uint32_t>(order[1]);
  return draft.files();
}

/// An isometry of the metric or not, in any case not in G: a translation by a third of a short lattice
/// vector.
Isometry outside(const Base& base, Random& random) {
  const Vector v = base.group().lattice().column(random.between(0, base.dimension() - 1));
  return Isometry::translate(Rational(ref::Integer(1), ref::Integer(random.between(3, 1000))) * v);
}

std::optional<Files> vertex_outside(const Base& base, Random& random) {
  Draft draft(base);
  FileVertex& v = draft.cells()[random.below(base.cell_count())][random.below(base.corners())];
  const Isometry g = outside(base, random) * draft.element(v);
  v = {v.point, draft.index_of(g)};
  return draft.files();
}

std::optional<Files> unused_outside(const Base& base, Random& random) {
  Draft draft(base);
  std::vector<Isometry>& elements = draft.triangulation().elements;
  const Isometry element = elements[random.below(elements.size())];
  elements.push_back(outside(base, random) * element);
  return draft.files();
}

/// The mirror image of one cell in a coordinate plane through its first corner.
std::optional<Files> cell_reflected(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t c = random.below(base.cell_count());
  const Vector& centre = base.cell(c)[random.below(base.corners())];
  ref::Matrix mirror = ref::Matrix::identity(base.dimension());
  const int axis = random.between(0, base.dimension() - 1);
  mirror(axis, axis) = Rational(-1);
  const Isometry s{mirror, centre - mirror * centre};
  draft.cells()[c] = draft.moved(s, draft.cells()[c]);
  for (std::size_t i = 0; i < base.corners(); ++i)
    if (!base.group().contains(draft.element(draft.cells()[c][i]))) return draft.files();
  return std::nullopt;
}

std::optional<Files> point_out_of_range(const Base& base, Random& random) {
  Draft draft(base);
  draft.cells()[random.below(base.cell_count())][random.below(base.corners())].point =
      static_cast<std::uint32_t>(base.instance().points.size());
  return draft.files();
}

std::optional<Files> element_out_of_range(const Base& base, Random& random) {
  Draft draft(base);
  draft.cells()[random.below(base.cell_count())][random.below(base.corners())].element =
      static_cast<std::uint32_t>(base.triangulation().elements.size());
  return draft.files();
}

}  // namespace

std::vector<Kind> label_kinds() {
  const Expectation one_cell = breaks({Name::facets_paired});
  const Expectation outside_group = breaks({Name::subgroup_member});
  const Expectation elsewhere =
      breaks({}, {Name::cells_nondegenerate, Name::volume_exact, Name::delaunay_empty},
             {Name::vertices_complete, Name::facets_paired});
  return {
      {"point of one vertex changed", "lemma on one cell", one_cell, other_point},
      {"element of one vertex changed", "lemma on one cell", one_cell, other_element},
      {"offset of one vertex changed", "lemma on one cell", one_cell, other_offset},
      {"vertex in a wrong coset", "lemma on one cell", one_cell, wrong_coset},
      {"facet glued by a wrong element", "lemma on one cell", one_cell, wrong_gluing},
      {"elements inverted", "a facet that does not occur twice was counted", one_cell, inverted_elements},
      {"listed element changed", "a facet that does not occur twice was counted", one_cell,
       listed_element_changed},
      {"two listed elements exchanged", "a facet that does not occur twice was counted", one_cell,
       two_elements_exchanged},
      {"two points exchanged in the cells", "the same complex, its vertices elsewhere (reposition.hpp)",
       elsewhere, two_points_exchanged},
      {"lifts of one point shifted in the cells", "the same complex, its vertices elsewhere (reposition.hpp)",
       elsewhere, point_shifted_in_cells},
      {"two points merged in the cells", "one point is no vertex", breaks({Name::vertices_complete}),
       points_merged},
      {"vertex outside the orbit", "its element is not in the group", outside_group, vertex_outside},
      {"unused element outside the group", "every listed element must be in the group", outside_group,
       unused_outside},
      {"cell reflected", "an element of it is not in the group", outside_group, cell_reflected},
      {"point index out of range", "the grammar forbids it", unreadable(), point_out_of_range},
      {"element index out of range", "the grammar forbids it", unreadable(), element_out_of_range},
  };
}

}  // namespace flatdt::edits
