#include "complex_audit.hpp"

#include <algorithm>
#include <map>

#include "geometry.hpp"
#include "judge.hpp"
#include "require.hpp"

namespace flatdt::property_tests {
namespace {

using ref::CellId;
using ref::Element;
using ref::Isometry;
using ref::OrbitPoint;
using ref::Rational;
using ref::Vector;
using ref::VertexId;

template <int D>
std::vector<OrbitPoint> facet_points(const ref::GroupTable& table, const ref::CellPoints<D>& cell,
                                     std::uint32_t facet, const Element& mover) {
  std::vector<OrbitPoint> points;
  for (std::uint32_t k = 0; k <= D; ++k)
    if (k != facet) points.push_back({cell[k].site, table.multiply(mover, cell[k].g)});
  std::sort(points.begin(), points.end());
  return points;
}

template <int D>
void require_adjacency(const ref::QuotientComplex<D>& complex) {
  const ref::GroupTable& table = complex.table();
  for (std::uint32_t i = 0; i < complex.cell_slots(); ++i) {
    const CellId c{i};
    const auto& cell = complex.cell(c);
    if (!cell.is_alive()) continue;
    for (std::uint32_t k = 0; k <= D; ++k) {
      const CellId n = cell.neighbour[k];
      require(index_of(n) < complex.cell_slots() && complex.cell(n).is_alive(), "a neighbour is no cell");
      const auto& other = complex.cell(n);
      std::uint32_t f = 0;
      while (f <= D &&
             !(other.neighbour[f] == c && complex.gluing(n, f) == table.inverse(complex.gluing(c, k))))
        ++f;
      require(f <= D, "neighbours do not know each other");
      require(facet_points<D>(table, complex.base_points(c), k, {}) ==
                  facet_points<D>(table, complex.base_points(n), f, complex.gluing(c, k)),
              "glued cells do not share the facet");
    }
  }
}

template <int D>
void require_vertices(const ref::QuotientComplex<D>& complex, const std::vector<std::vector<bool>>& present) {
  for (std::size_t site = 0; site < present.size(); ++site) {
    const ref::SiteId id{static_cast<std::uint32_t>(site)};
    if (!complex.has_site(id)) continue;
    for (std::uint32_t rep = 0; rep < complex.subgroup().index(); ++rep) {
      const VertexId v = complex.vertex_of(id, rep);
      const CellId c = complex.vertex(v).cell;
      if (!present[site][rep]) {
        require(c == ref::kNoCell, "a vertex that was not inserted has a cell");
        continue;
      }
      require(c != ref::kNoCell && complex.cell(c).is_alive(), "a vertex names a cell that is gone");
      const auto& vertices = complex.cell(c).vertex;
      require(std::find(vertices.begin(), vertices.end(), v) != vertices.end(),
              "a vertex names a cell that is not its own");
    }
  }
}

/// Orientation of the base lifts, and the list L.
template <int D>
void require_cells(const Engine<D>& engine, const ref::PeriodicDelaunay<D>& level) {
  const auto& complex = level.complex();
  std::size_t large = 0;
  for (std::uint32_t i = 0; i < complex.cell_slots(); ++i) {
    if (!complex.cell(CellId{i}).is_alive()) continue;
    std::vector<Vector> corners;
    for (const OrbitPoint& p : complex.base_points(CellId{i})) corners.push_back(engine.position(p));
    require(orientation(corners) == ref::Sign::positive, "a base lift is not positively oriented");
    if (level.is_on_manifold()) continue;
    const Sphere sphere = *circumsphere(engine.analysis.frame.gram, corners);
    const bool is_large = Rational(16) * sphere.squared_radius >= engine.analysis.frame.delta_squared;
    require(level.is_large(CellId{i}) == is_large, "a cell is wrongly in the list L, or missing from it");
    if (is_large) ++large;
  }
  require(level.is_on_manifold() || level.large_cells() == large, "the list L is counted wrongly");
}

/// The complex as an instance of the group H, in frame coordinates, and a triangulation of E^d/H.
template <int D>
void require_verified_by_checker(const Engine<D>& engine, const ref::PeriodicDelaunay<D>& level,
                                 const std::vector<std::vector<bool>>& present, const ref::Matrix& lattice) {
  const auto& complex = level.complex();
  ref::Instance instance;
  instance.dimension = D;
  instance.generators_given = true;
  instance.gram = engine.analysis.frame.gram;
  if (level.is_on_manifold()) instance.generators = engine.analysis.frame.cosets;
  for (int j = 0; j < D; ++j) instance.generators.push_back(Isometry::translate(lattice.column(j)));
  std::map<VertexId, std::uint32_t> number;
  for (std::size_t site = 0; site < present.size(); ++site)
    for (std::uint32_t rep = 0; rep < complex.subgroup().index(); ++rep) {
      if (!present[site][rep]) continue;
      const VertexId v = complex.vertex_of(ref::SiteId{static_cast<std::uint32_t>(site)}, rep);
      number[v] = static_cast<std::uint32_t>(instance.points.size());
      instance.points.push_back(engine.position(complex.point(v)));
    }
  ref::Triangulation triangulation;
  triangulation.dimension = D;
  std::map<Element, std::uint32_t> elements;
  for (std::uint32_t i = 0; i < complex.cell_slots(); ++i) {
    const auto& cell = complex.cell(CellId{i});
    if (!cell.is_alive()) continue;
    std::array<ref::Triangulation::CellVertex, 4> vertices{};
    for (std::size_t k = 0; k <= D; ++k) {
      const auto [entry, is_new] = elements.try_emplace(
          complex.offset(CellId{i}, k), static_cast<std::uint32_t>(triangulation.elements.size()));
      if (is_new) triangulation.elements.push_back(engine.table.isometry(complex.offset(CellId{i}, k)));
      const auto point = number.find(cell.vertex[k]);
      require(point != number.end(), "a cell has a vertex that was not inserted");
      vertices[k] = {point->second, entry->second};
    }
    triangulation.cells.push_back(vertices);
  }
  require_verified(instance, triangulation);
}

}  // namespace

template <int D>
void audit_complex(const Engine<D>& engine, const ref::PeriodicDelaunay<D>& level,
                   const std::vector<std::vector<bool>>& present, const ref::Matrix& lattice) {
  require_adjacency<D>(level.complex());
  require_vertices<D>(level.complex(), present);
  require_cells<D>(engine, level);
  require_verified_by_checker<D>(engine, level, present, lattice);
}

template <int D>
void require_in_closure(const Engine<D>& engine, const ref::PeriodicDelaunay<D>& level, ref::SiteId site,
                        const ref::Location& at) {
  std::vector<Vector> corners;
  for (const OrbitPoint& p : level.complex().base_points(at.cell)) corners.push_back(engine.position(p));
  const Vector query = engine.position({site, at.seen});
  for (std::size_t k = 0; k <= D; ++k) {
    std::vector<Vector> replaced = corners;
    replaced[k] = query;
    require(orientation(replaced) != ref::Sign::negative, "the located cell does not contain the query");
  }
}

template void audit_complex<2>(const Engine<2>&, const ref::PeriodicDelaunay<2>&,
                               const std::vector<std::vector<bool>>&, const ref::Matrix&);
template void audit_complex<3>(const Engine<3>&, const ref::PeriodicDelaunay<3>&,
                               const std::vector<std::vector<bool>>&, const ref::Matrix&);
template void require_in_closure<2>(const Engine<2>&, const ref::PeriodicDelaunay<2>&, ref::SiteId,
                                    const ref::Location&);
template void require_in_closure<3>(const Engine<3>&, const ref::PeriodicDelaunay<3>&, ref::SiteId,
                                    const ref::Location&);

}  // namespace flatdt::property_tests
