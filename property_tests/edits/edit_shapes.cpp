/// Edits that put other simplices in the place of cells: split, flat, folded, contracted.
#include <algorithm>
#include <set>

#include "draft.hpp"
#include "geometry.hpp"

namespace flatdt::edits {

using Name = checker::ConditionName;
using ref::Isometry;
using ref::Rational;
using ref::Vector;

namespace {

const Conditions kTiling = {Name::cells_nondegenerate, Name::facets_paired, Name::facets_opposite,
                            Name::volume_exact};

/// The cell, with each corner in turn replaced by one vertex.
std::vector<FileCell> cone(const FileCell& cell, FileVertex apex, std::size_t corners) {
  std::vector<FileCell> all(corners, cell);
  for (std::size_t i = 0; i < corners; ++i) all[i][i] = apex;
  return all;
}

/// Splits a cell at a new point of its interior that is in the ball of a neighbour, or in none, as wanted.
/// Inside the star of the new point the lifted function is convex, as the point is lifted below the cell; so
/// the facets of the cell decide.
std::optional<Files> split_at_new_point(const Base& base, Random& random, bool in_a_ball) {
  std::vector<std::size_t> order = random.order(base.cell_count());
  order.resize(std::min<std::size_t>(order.size(), 60));
  for (const std::size_t c : order) {
    for (int attempt = 0; attempt < 12; ++attempt) {
      Rational sum;
      Vector point(base.dimension());
      for (const Vector& v : base.cell(c)) {
        const Rational weight(random.between(1, attempt == 0 ? 2 : 40));
        sum += weight;
        point = point + weight * v;
      }
      point = (Rational(1) / sum) * point;
      bool found = false;
      for (std::size_t i = 0; i < base.corners(); ++i) {
        const Base::Neighbour& n = base.neighbour(c, i);
        std::vector<Vector> other;
        for (const Vector& v : base.cell(n.cell)) other.push_back(n.to * v);
        found = found || in_ball(base.instance().gram, other, point) > 0;
      }
      if (found != in_a_ball) continue;
      Draft draft(base);
      const auto fresh = static_cast<std::uint32_t>(draft.instance().points.size());
      draft.instance().points.push_back(point);
      const FileVertex apex{fresh, draft.index_of(Isometry::identity(base.dimension()))};
      const FileCell cell = draft.cells()[c];
      draft.remove_cells({c});
      for (const FileCell& part : cone(cell, apex, base.corners())) draft.cells().push_back(part);
      return draft.files();
    }
  }
  return std::nullopt;
}

std::optional<Files> split_breaking(const Base& base, Random& random) {
  return base.on_manifold() ? split_at_new_point(base, random, true) : std::nullopt;
}
std::optional<Files> split_keeping(const Base& base, Random& random) {
  return base.on_manifold() ? split_at_new_point(base, random, false) : std::nullopt;
}
std::optional<Files> split_one_sheet(const Base& base, Random& random) {
  return base.on_manifold() ? std::nullopt : split_at_new_point(base, random, random.below(2) == 0);
}

std::optional<Files> split_at_vertex(const Base& base, Random& random) {
  Draft draft(base);
  const std::size_t c = random.below(base.cell_count());
  const Base::Neighbour& n = base.neighbour(c, random.below(base.corners()));
  const FileVertex apex = draft.moved(n.to, file_vertex(base, n.cell, n.corner));
  const FileCell cell = draft.cells()[c];
  draft.remove_cells({c});
  for (const FileCell& part : cone(cell, apex, base.corners())) draft.cells().push_back(part);
  return draft.files();
}

/// Three points of a line in the plane, four of a parallelogram in space: copies of one point under
/// translations.
FileCell flat_cell(const Base& base, Draft& draft, Random& random) {
  const FileVertex start = file_vertex(base, random.below(base.cell_count()), 0);
  const ref::Matrix& lattice = base.group().lattice();
  const int first = random.between(0, base.dimension() - 1);
  const Isometry a = Isometry::translate(lattice.column(first));
  const Isometry b = base.dimension() == 2 ? a : Isometry::translate(lattice.column((first + 1) % 3));
  FileCell cell{start, draft.moved(a, start), draft.moved(a * b, start), start};
  if (base.dimension() == 3) cell[3] = draft.moved(b, start);
  return cell;
}

std::optional<Files> flat_added(const Base& base, Random& random) {
  Draft draft(base);
  draft.cells().push_back(flat_cell(base, draft, random));
  return draft.files();
}

std::optional<Files> flat_instead(const Base& base, Random& random) {
  Draft draft(base);
  draft.cells()[random.below(base.cell_count())] = flat_cell(base, draft, random);
  return draft.files();
}

std::optional<Files> vertex_repeated(const Base& base, Random& random) {
  Draft draft(base);
  FileCell& cell = draft.cells()[random.below(base.cell_count())];
  const std::vector<std::size_t> order = random.order(base.corners());
  cell[order[0]] = cell[order[1]];
  return draft.files();
}

/// The boundary of the simplex on the d+2 points of two neighbours, where the edge between the apices crosses
/// the interior of the facet: both triangulations of the points, glued along their boundary.
std::optional<Files> pillow(const Base& base, Random& random) {
  for (const std::size_t c : random.order(base.cell_count())) {
    for (const std::size_t corner : random.order(base.corners())) {
      const Vector apex = base.apex_across(c, corner);
      const Vector& top = base.cell(c)[corner];
      if (base.subgroup().canonical(apex).point == base.subgroup().canonical(top).point) continue;
      const int sign = orientation(base.cell(c));
      bool crosses = true;
      for (std::size_t i = 0; i < base.corners(); ++i)
        crosses = crosses && (i == corner || orientation(replaced(base.cell(c), i, apex)) * sign > 0);
      if (!crosses) continue;
      Draft draft(base);
      const Base::Neighbour& n = base.neighbour(c, corner);
      const FileVertex far = draft.moved(n.to, file_vertex(base, n.cell, n.corner));
      const FileCell near = draft.cells()[c];
      draft.cells() = cone(near, far, base.corners());
      draft.cells().push_back(near);
      if (facets_are_paired(draft.data(), base.subgroup())) return draft.files();
    }
  }
  return std::nullopt;
}

/// The cells at an edge (v, w) removed, and v moved into w in all others.
std::optional<Files> contract_edge(const Base& base, Random& random) {
  const std::size_t start = random.below(base.cell_count());
  const CrystalGroup& h = base.subgroup();
  const CrystalGroup::Canonical v = h.canonical(base.cell(start)[0]);
  Draft draft(base);
  // The edge is moved to where v is canonical; then so is every other lift of it.
  const Isometry to_w = v.mover * draft.element(file_vertex(base, start, 1));
  const std::uint32_t w_point = file_vertex(base, start, 1).point;
  std::vector<std::size_t> gone;
  for (std::size_t c = 0; c < base.cell_count(); ++c)
    for (std::size_t i = 0; i < base.corners(); ++i) {
      const CrystalGroup::Canonical here = h.canonical(base.cell(c)[i]);
      if (here.point != v.point) continue;
      const Isometry lift = here.mover.inverse() * to_w;
      const Vector w = lift * base.instance().points[w_point];
      if (std::find(base.cell(c).begin(), base.cell(c).end(), w) != base.cell(c).end()) gone.push_back(c);
      draft.cells()[c][i] = {w_point, draft.index_of(lift)};
    }
  draft.remove_cells(gone);
  return draft.files();
}

}  // namespace

std::vector<Kind> shape_kinds() {
  return {
      {"cell split at a new point in another ball", "the point is strictly inside the ball of a neighbour",
       breaks({Name::delaunay_empty}, {},
              {Name::vertices_complete, Name::cells_nondegenerate, Name::facets_paired, Name::facets_opposite,
               Name::volume_exact}),
       split_breaking},
      {"cell split at a new point in no other ball", "then this is how the Delaunay triangulation changes",
       keeps(), split_keeping},
      {"cell split in one sheet of a cover", "the other copies of the new point are no vertices",
       breaks({Name::vertices_complete}, {}, kTiling), split_one_sheet},
      {"cell split at an old vertex", "the cone from a point outside a cell over its facets has more volume",
       breaks({Name::volume_exact}), split_at_vertex},
      {"flat cell added", "it has volume 0", breaks({Name::cells_nondegenerate}), flat_added},
      {"flat cell instead of a cell", "it has volume 0; lemma on one cell",
       breaks({Name::cells_nondegenerate, Name::facets_paired}), flat_instead},
      {"vertex twice in a cell", "it has volume 0; lemma on one cell",
       breaks({Name::cells_nondegenerate, Name::facets_paired}), vertex_repeated},
      {"pillow", "a sphere with d+2 vertices, folded along its outer facets",
       breaks({Name::vertices_complete, Name::facets_opposite, Name::topology_homology}, {},
              {Name::facets_paired}),
       pillow},
      {"edge contracted", "one vertex modulo H is gone", breaks({Name::vertices_complete}), contract_edge},
  };
}

}  // namespace flatdt::edits
