#include "quotient.hpp"

#include <algorithm>
#include <map>

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
  InstanceElements(const ref::PreparedGroup& group, const std::vector<ref::Site>& sites)
      : group_(group), sites_(sites), to_frame_(group.to_instance().inverse()) {}

  [[nodiscard]] Isometry conjugate(const Isometry& g) const { return group_.to_instance() * g * to_frame_; }

  /// The element e with e * points[site.point] = p.
  [[nodiscard]] Isometry at(const OrbitPoint& p) const {
    const ref::Site& site = sites_[index_of(p.site)];
    constexpr std::int32_t kSmall = 1000;
    const std::array<std::int32_t, 3>& t = site.form->translation;
    const bool is_small = !site.is_large() && std::all_of(t.begin(), t.end(), [](std::int32_t x) {
      return -kSmall < x && x < kSmall;
    });
    if (!is_small) return conjugate(group_.table().isometry(p.g) * site.from_site(group_.frame()).inverse());
    Element from_site{{}, site.form->coset};
    for (std::size_t i = 0; i < 3; ++i) from_site.t[i] = static_cast<std::int16_t>(t[i]);
    const Element g = group_.table().multiply(p.g, group_.table().inverse(from_site));
    return group_.in_instance(g.coset, {g.t[0], g.t[1], g.t[2]});
  }

 private:
  const ref::PreparedGroup& group_;
  const std::vector<ref::Site>& sites_;
  Isometry to_frame_;
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
Quotient computed(const ref::Instance& instance, const ref::PreparedGroup& group,
                  const QuotientOptions& options) {
  const ref::Frame& frame = group.frame();
  const ref::GroupTable& table = group.table();
  const std::vector<ref::Site> sites = ref::make_sites(frame, instance.points);
  const ref::TieOrder& order = group.order();
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
  const InstanceElements elements(group, sites);
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

Quotient quotient(const ref::Instance& instance, const ref::PreparedGroup& group,
                  const QuotientOptions& options) {
  if (instance.dimension == 2) return computed<2>(instance, group, options);
  return computed<3>(instance, group, options);
}

}  // namespace flatdt::fuzz
