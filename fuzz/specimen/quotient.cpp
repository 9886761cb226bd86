#include "quotient.hpp"

#include <map>
#include <optional>

#include "flatdt/ref/delaunay_hierarchy.hpp"
#include "flatdt/ref/skeleton_cycles.hpp"

namespace flatdt::fuzz {
namespace {

using ref::Element;
using ref::Isometry;
using ref::OrbitPoint;
using ref::SiteId;

/// Elements of the frame's group applied to sites, as elements of the instance's group applied to its points.
class InstanceElements {
 public:
  InstanceElements(const ref::Frame& frame, const ref::GroupTable& table, const std::vector<ref::Site>& sites)
      : table_(table),
        to_instance_{frame.basis, frame.origin},
        to_frame_(to_instance_.inverse()),
        untranslated_(sites.size() * static_cast<std::size_t>(table.cosets())) {
    for (const ref::Site& site : sites) point_to_site_.push_back(site.from_site.inverse() * to_frame_);
  }

  [[nodiscard]] Isometry conjugate(const Isometry& g) const { return to_instance_ * g * to_frame_; }

  /// The element e with e * points[site.point] = p. A translation only adds vectors of the basis to what is
  /// the same for all points of one coset.
  [[nodiscard]] Isometry at(const OrbitPoint& p) {
    const std::size_t site = index_of(p.site);
    std::optional<Isometry>& base =
        untranslated_[site * static_cast<std::size_t>(table_.cosets()) + p.g.coset];
    if (!base) base = to_instance_ * table_.isometry(Element{{}, p.g.coset}) * point_to_site_[site];
    Isometry element = *base;
    for (int j = 0; j < table_.dimension(); ++j) {
      const long t = p.g.t[static_cast<std::size_t>(j)];
      if (t == 0) continue;
      for (int i = 0; i < table_.dimension(); ++i)
        element.translation[i] += ref::Rational(t) * to_instance_.linear(i, j);
    }
    return element;
  }

 private:
  const ref::GroupTable& table_;
  Isometry to_instance_;
  Isometry to_frame_;
  std::vector<Isometry> point_to_site_;
  std::vector<std::optional<Isometry>> untranslated_;
};

/// Generators of H, which holds all translations: these and an element of each coset.
void set_subgroup(const ref::Subgroup& subgroup, const ref::GroupTable& table,
                  const InstanceElements& elements, ref::Triangulation& result) {
  if (subgroup.is_whole()) return;
  result.has_subgroup = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(table.dimension()); ++i) {
    Element unit;
    unit.t[i] = 1;
    result.subgroup.push_back(elements.conjugate(table.isometry(unit)));
  }
  for (int c = 1; c < table.cosets(); ++c) {
    const Element element{{}, static_cast<std::uint16_t>(c)};
    if (subgroup.split(element).rep == 0)
      result.subgroup.push_back(elements.conjugate(table.isometry(element)));
  }
}

/// The place of an element in the list, where it is put if it is new.
std::uint32_t number_of(const Isometry& element, std::map<Isometry, std::uint32_t>& numbers,
                        ref::Triangulation& result) {
  const auto [entry, is_new] = numbers.try_emplace(element, static_cast<std::uint32_t>(numbers.size()));
  if (is_new) result.elements.push_back(element);
  return entry->second;
}

template <int D>
Quotient computed(const ref::Instance& instance, const ref::Frame& frame, const QuotientOptions& options) {
  const ref::GroupTable table(frame);
  const std::vector<ref::Site> sites = ref::make_sites(frame, instance.points);
  const ref::TieOrder order(frame, table);
  const ref::Subgroup& subgroup = order.invariance_group();
  ref::Predicates<D> predicates(frame, table, sites, order, options.stages);
  ref::Circumradius<D> circumradius(frame, predicates);
  ref::DelaunayHierarchy<D> hierarchy(
      {&frame, &table, &sites, &order, &predicates, &circumradius, options.region_limit}, subgroup,
      ref::Insertion::without_covers);
  for (std::size_t k = 0; k < sites.size(); ++k)
    hierarchy.insert_orbit(SiteId{static_cast<std::uint32_t>((options.first + k) % sites.size())}, 0);
  const auto cells = ref::cells_modulo<D>(table, subgroup, hierarchy.full().complex().all_cells(), 1);
  ref::ensure(cells.has_value(), "each cell occurs once");

  Quotient result;
  if (subgroup.is_whole()) result.simplicial = !ref::find_short_cycle<D>(table, *cells);
  result.triangulation.dimension = D;
  InstanceElements elements(frame, table, sites);
  set_subgroup(subgroup, table, elements, result.triangulation);
  std::map<OrbitPoint, std::uint32_t> known;
  std::map<Isometry, std::uint32_t> numbers;
  for (const ref::CellPoints<D>& cell : *cells) {
    std::array<ref::Triangulation::CellVertex, 4> vertices{};
    for (std::size_t k = 0; k <= D; ++k) {
      const auto [entry, is_new] = known.try_emplace(cell[k], 0U);
      if (is_new) entry->second = number_of(elements.at(cell[k]), numbers, result.triangulation);
      vertices[k] = {sites[index_of(cell[k].site)].point, entry->second};
    }
    result.triangulation.cells.push_back(vertices);
  }
  return result;
}

}  // namespace

Quotient quotient(const ref::Instance& instance, const ref::GroupAnalysis& analysis,
                  const QuotientOptions& options) {
  if (instance.dimension == 2) return computed<2>(instance, analysis.frame, options);
  return computed<3>(instance, analysis.frame, options);
}

}  // namespace flatdt::fuzz
