#include "reposition.hpp"

#include "geometry.hpp"

namespace flatdt::edits {

using ref::Vector;

bool points_stay_distinct(const Base& base, const ref::Instance& now) {
  std::set<Vector> orbits;
  for (const Vector& p : now.points) orbits.insert(base.group().canonical(p).point);
  return orbits.size() == now.points.size();
}

Repositioned repositioned(const Base& base, const Case& now) {
  // What has not moved is as before.
  const bool same_metric = now.instance.gram == base.instance().gram;
  std::vector<std::vector<Vector>> cells;
  std::vector<bool> moved;
  bool turned = false;
  for (std::size_t c = 0; c < base.cell_count(); ++c) {
    cells.push_back(positions(now, now.triangulation.cells[c]));
    moved.push_back(cells.back() != base.cell(c));
    if (!moved.back()) continue;
    const int sign = orientation(cells.back());
    if (sign == 0) return Repositioned::flat;
    turned = turned || sign != orientation(base.cell(c));
  }
  if (turned) return Repositioned::folded;
  for (std::size_t c = 0; c < base.cell_count(); ++c)
    for (std::size_t i = 0; i < base.corners(); ++i) {
      const Base::Neighbour& n = base.neighbour(c, i);
      if (n.cell < c) continue;  // the relation is symmetric
      if (same_metric && !moved[c] && !moved[n.cell]) continue;
      if (in_ball(now.instance.gram, cells[c], n.to * cells[n.cell][n.corner]) > 0)
        return Repositioned::not_delaunay;
    }
  return Repositioned::valid;
}

}  // namespace flatdt::edits
