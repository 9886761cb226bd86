#include "flip.hpp"

#include <set>

#include "geometry.hpp"

namespace flatdt::edits {

using ref::Isometry;
using ref::Vector;

namespace {

FileCell with(FileCell cell, std::size_t corner, FileVertex v) {
  cell[corner] = v;
  return cell;
}

/// The apex across a facet, as a vertex of the file.
FileVertex far_vertex(const Base& base, Draft& draft, std::size_t cell, std::size_t corner) {
  const Base::Neighbour& n = base.neighbour(cell, corner);
  return draft.moved(n.to, file_vertex(base, n.cell, n.corner));
}

bool all_different(const std::vector<std::size_t>& numbers) {
  return std::set<std::size_t>(numbers.begin(), numbers.end()).size() == numbers.size();
}

/// The corner of a moved cell that is at a point.
std::size_t corner_at(const Base& base, std::size_t cell, const Isometry& to, const Vector& point) {
  for (std::size_t i = 0; i < base.corners(); ++i)
    if (to * base.cell(cell)[i] == point) return i;
  return base.corners();
}

}  // namespace

std::optional<Flip> facet_flip(const Base& base, Draft& draft, std::size_t cell, std::size_t corner) {
  const std::vector<Vector>& points = base.cell(cell);
  const Vector apex = base.apex_across(cell, corner);
  const int sign = orientation(points);
  for (std::size_t i = 0; i < base.corners(); ++i)
    if (i != corner && orientation(replaced(points, i, apex)) != sign) return std::nullopt;
  Flip flip;
  flip.gone = {cell, base.neighbour(cell, corner).cell};
  if (!all_different(flip.gone)) return std::nullopt;
  const FileVertex far = far_vertex(base, draft, cell, corner);
  for (std::size_t i = 0; i < base.corners(); ++i)
    if (i != corner) flip.come.push_back(with(base.triangulation().cells[cell], i, far));
  flip.tie = in_ball(base.instance().gram, points, apex) == 0;
  flip.adds_edge = true;
  flip.from = points[corner];
  flip.to = apex;
  return flip;
}

std::optional<Flip> edge_flip(const Base& base, Draft& draft, std::size_t cell, std::size_t k,
                              std::size_t l) {
  const std::vector<Vector>& points = base.cell(cell);
  const Vector apex = base.apex_across(cell, k);
  if (base.apex_across(cell, l) != apex) return std::nullopt;
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != k && i != l) ends.push_back(i);
  // One cell in the place of each end of the edge; both as the old cell is oriented.
  const int sign = orientation(points);
  for (const std::size_t end : ends)
    if (orientation(replaced(points, end, apex)) != sign) return std::nullopt;
  Flip flip;
  flip.gone = {cell, base.neighbour(cell, k).cell, base.neighbour(cell, l).cell};
  if (!all_different(flip.gone)) return std::nullopt;
  const FileVertex far = far_vertex(base, draft, cell, k);
  for (const std::size_t end : ends) flip.come.push_back(with(base.triangulation().cells[cell], end, far));
  flip.tie = in_ball(base.instance().gram, points, apex) == 0;
  return flip;
}

std::optional<Flip> quadrilateral_flip(const Base& base, Draft& draft, std::size_t cell, std::size_t corner,
                                       bool filled) {
  const std::vector<Vector>& points = base.cell(cell);
  const Vector apex = base.apex_across(cell, corner);
  const int sign = orientation(points);
  std::size_t top = base.corners();  // the corner that is not in the plane of the quadrilateral
  for (std::size_t i = 0; i < base.corners(); ++i) {
    if (i == corner) continue;
    const int side = orientation(replaced(points, i, apex));
    if (side == 0 && top == base.corners())
      top = i;
    else if (side != sign)
      return std::nullopt;
  }
  if (top == base.corners()) return std::nullopt;
  const Base::Neighbour& n = base.neighbour(cell, corner);
  const FileVertex far = far_vertex(base, draft, cell, corner);
  const FileCell& here = base.triangulation().cells[cell];
  Flip flip;
  flip.gone = {cell, n.cell};
  flip.tie = in_ball(base.instance().gram, points, apex) == 0;
  flip.adds_edge = true;
  flip.from = points[corner];
  flip.to = apex;
  for (std::size_t i = 0; i < base.corners(); ++i)
    if (i != corner && i != top) flip.come.push_back(with(here, i, far));
  if (filled) {
    flip.come.push_back(with(here, top, far));
  } else {
    const Base::Neighbour& below = base.neighbour(cell, top);
    const std::size_t far_top = corner_at(base, n.cell, n.to, points[top]);
    const Base::Neighbour& far_below = base.neighbour(n.cell, far_top);
    if (base.apex_across(cell, top) != n.to * base.apex_across(n.cell, far_top)) return std::nullopt;
    flip.gone.push_back(below.cell);
    flip.gone.push_back(far_below.cell);
    const FileCell under = with(here, top, far_vertex(base, draft, cell, top));
    for (std::size_t i = 0; i < base.corners(); ++i)
      if (i != corner && i != top) flip.come.push_back(with(under, i, far));
  }
  if (!all_different(flip.gone)) return std::nullopt;
  return flip;
}

void apply(const Flip& flip, Draft& draft) {
  draft.remove_cells(flip.gone);
  for (const FileCell& cell : flip.come) draft.cells().push_back(cell);
}

}  // namespace flatdt::edits
