#include "flatdt/ref/quotient_complex.hpp"

#include <algorithm>

namespace flatdt::ref {

template <int D>
void QuotientComplex<D>::add_site(SiteId site) {
  ensure(!has_site(site), "a site is added once");
  const std::array<double, 3> approximate = (*sites_)[index_of(site)].approximate();
  first_vertex_[index_of(site)] = static_cast<std::uint32_t>(vertices_.size());
  for (std::uint32_t rep = 0; rep < subgroup_.index(); ++rep) {
    vertices_.push_back({table_->apply(subgroup_.representative(rep), approximate), site, kNoCell});
  }
}

template <int D>
CellId QuotientComplex<D>::new_cell() {
  CellId c = kNoCell;
  if (!free_.empty()) {
    c = free_.back();
    free_.pop_back();
  } else {
    // About 5 GB: beyond it a machine of ordinary size would start to swap rather than fail cleanly.
    constexpr std::size_t kMaxCells = std::size_t{1} << 26;
    if (cells_.size() >= kMaxCells)
      throw LimitReached("the complex needs more than " + std::to_string(kMaxCells) +
                         " cells: too many points for a cover of " + std::to_string(subgroup_.index()) +
                         " sheets");
    c = CellId{static_cast<std::uint32_t>(cells_.size())};
    cells_.push_back({});
  }
  return c;
}

template <int D>
void QuotientComplex<D>::delete_cell(CellId c) {
  cell(c).vertex[0] = kNoVertex;
  if (cell(c).elements != 0) free_elements_.push_back(cell(c).elements);
  cell(c).elements = 0;
  free_.push_back(c);
}

template <int D>
void QuotientComplex<D>::make_elements(CellId c) {
  CellElements none;
  none.offset.fill(ElementStore::kIdentity);
  none.gluing.fill(ElementStore::kIdentity);
  if (free_elements_.empty()) {
    if (cell_elements_.empty()) cell_elements_.push_back(none);
    free_elements_.push_back(static_cast<std::uint32_t>(cell_elements_.size()));
    cell_elements_.push_back(none);
  }
  cell(c).elements = free_elements_.back();
  free_elements_.pop_back();
  cell_elements_[cell(c).elements] = none;
}

template <int D>
void QuotientComplex<D>::reserve(std::size_t vertices) {
  vertices_.reserve(vertices);
  // Expected cells of evenly spread points: 24 pi^2 / 35 = 6.77 a point in space [Meijering53], 2 in the
  // plane.
  cells_.reserve(D == 2 ? 2 * vertices : vertices * 69 / 10);
}

template <int D>
typename QuotientComplex<D>::FacetOccurrence QuotientComplex<D>::facet(CellId c, const CellPoints<D>& points,
                                                                       std::uint32_t k) const {
  std::array<OrbitPoint, D> face;
  for (std::size_t j = 0, i = 0; j <= D; ++j)
    if (j != k) face[i++] = points[j];
  const CanonicalFace<D> canonical = canonical_face<D>(*table_, subgroup_, face);
  return {canonical.key, canonical.multiplier, c, k};
}

template <int D>
std::uint32_t QuotientComplex<D>::mirror_facet(CellId c, std::uint32_t k) const {
  const Element back = table_->inverse(gluing(c, k));
  const CellId n = cell(c).neighbour[k];
  const Cell& outside = cell(n);
  std::uint32_t f = 0;
  while (f <= D && !(outside.neighbour[f] == c && gluing(n, f) == back)) ++f;
  ensure(f <= D, "neighbours know each other");
  return f;
}

template <int D>
CellId QuotientComplex<D>::add_cell(CellPoints<D> points, Predicates<D>& predicates) {
  std::array<Lift, D + 1> lifts;
  for (std::size_t k = 0; k <= D; ++k) lifts[k] = lift(points[k]);
  const Sign sign = predicates.orientation(lifts);
  ensure(sign != Sign::zero, "a cell is not flat");
  if (sign == Sign::negative) std::swap(points[0], points[1]);
  const CellId id = new_cell();
  for (std::size_t k = 0; k <= D; ++k) {
    const Subgroup::Split split = subgroup_.split(points[k].g);
    const VertexId v = vertex_of(points[k].site, split.rep);
    set_vertex(id, k, v, split.s);
    vertex(v).cell = id;
  }
  return id;
}

template <int D>
void QuotientComplex<D>::glue(const std::vector<FacetOccurrence>& facets) {
  // Equal keys come together by their hashes.
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(facets.size());
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    std::uint64_t hash = 0;
    for (const OrbitPoint& p : facets[i].key)
      hash = (hash ^ index_of(p.site) ^ p.g.packed()) * 0x9e3779b97f4a7c15U;
    order.emplace_back(hash, i);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && order[end].first == order[begin].first) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      const FacetOccurrence& a = facets[order[i].second];
      std::size_t equal = 0;
      for (std::size_t j = begin; j < end; ++j) {
        const FacetOccurrence& b = facets[order[j].second];
        if (i == j || a.key != b.key) continue;
        ++equal;
        if (j < i) continue;
        // a.n * facet_a = key = b.n * facet_b, so the neighbour across facet_a is (a.n^-1 b.n) * cell_b.
        const Element gluing = table_->multiply(table_->inverse(a.multiplier), b.multiplier);
        set_neighbour(a.cell, a.facet, b.cell, gluing);
        set_neighbour(b.cell, b.facet, a.cell, table_->inverse(gluing));
      }
      ensure(equal == 1, "every facet modulo H occurs exactly twice");
    }
    begin = end;
  }
}

template <int D>
void QuotientComplex<D>::assume_cells(const QuotientComplex& of_one_orbit) {
  ensure(
      cells_.empty() && vertices_.size() == 1 && of_one_orbit.vertices_.size() == 1 && table_->cosets() == 1,
      "cells are taken over from one orbit of a torus to another");
  for (const Cell& cell : of_one_orbit.cells_) cells_.push_back(cell);
  cell_elements_ = of_one_orbit.cell_elements_;
  codes_ = of_one_orbit.codes_;
  vertices_[0].cell = of_one_orbit.vertices_[0].cell;
}

template <int D>
void QuotientComplex<D>::assemble(const std::vector<CellPoints<D>>& cells, Predicates<D>& predicates) {
  ensure(cells_.empty(), "assemble fills an empty complex");
  std::vector<FacetOccurrence> facets;
  facets.reserve(cells.size() * (D + 1));
  cells_.reserve(cells.size());
  for (const CellPoints<D>& points : cells) {
    const CellId id = add_cell(points, predicates);
    const CellPoints<D> base = base_points(id);
    for (std::uint32_t k = 0; k <= D; ++k) facets.push_back(facet(id, base, k));
  }
  glue(facets);
}

template <int D>
std::vector<CellPoints<D>> QuotientComplex<D>::all_cells() const {
  std::vector<CellPoints<D>> cells;
  cells.reserve(cell_count());
  for (std::uint32_t c = 0; c < cells_.size(); ++c)
    if (cells_[c].is_alive()) cells.push_back(base_points(CellId{c}));
  return cells;
}

template <int D>
CellList<D> QuotientComplex<D>::release_cells() && {
  // Everything that is not needed for the points of a cell goes first.
  free_ = {};
  free_elements_ = {};
  WideElementStore codes;
  // A complex cell of d+1 vertices and neighbours is not smaller than d+1 points.
  auto cells = std::move(cells_).template turned<typename CellList<D>::Cell>(
      [this, &codes](const Cell& cell, typename CellList<D>::Cell& points) {
        if (!cell.is_alive()) return false;
        for (std::size_t k = 0; k <= D; ++k) {
          const OrbitPoint base = point(cell.vertex[k]);
          const Element offset =
              cell.elements == 0 ? Element{} : codes_[cell_elements_[cell.elements].offset[k]];
          points[k] = {index_of(base.site), codes.code(table_->multiply(offset, base.g))};
        }
        return true;
      });
  return {std::move(cells), std::move(codes)};
}

template class QuotientComplex<2>;
template class QuotientComplex<3>;

}  // namespace flatdt::ref
