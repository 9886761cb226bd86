#include "flatdt/ref/prepared_group.hpp"

#include <algorithm>
#include <string>

#include "flatdt/ref/first_orbit.hpp"

namespace flatdt::ref {
namespace {

const Frame& checked_size(const Frame& frame) {
  constexpr std::size_t kMaxMetricBits = 4608;
  for (int i = 0; i < frame.dimension; ++i)
    for (int j = i; j < frame.dimension; ++j) {
      const Rational& entry = frame.gram(i, j);
      if (std::max(entry.numerator().bits(), entry.denominator().bits()) > kMaxMetricBits)
        throw LimitReached(
            "entry (" + std::to_string(i + 1) + "," + std::to_string(j + 1) +
            ") of the metric of the reduced lattice has a numerator or denominator of more than " +
            std::to_string(kMaxMetricBits) + " bits");
    }
  return frame;
}

}  // namespace

PreparedGroup::PreparedGroup(const GroupAnalysis& analysis)
    : frame_(checked_size(analysis.frame)),
      table_(frame_),
      order_(frame_, table_),
      to_instance_{frame_.basis, frame_.origin},
      site_maps_(frame_) {
  if (frame_.dimension == 2) {
    std::get<0>(metrics_) = std::make_shared<const IntegralMetric<2>>(frame_);
    std::get<0>(circumradii_) = std::make_shared<const CircumradiusConstants<2>>(frame_);
  } else {
    std::get<1>(metrics_) = std::make_shared<const IntegralMetric<3>>(frame_);
    std::get<1>(circumradii_) = std::make_shared<const CircumradiusConstants<3>>(frame_);
  }
  const Isometry back = to_instance_.inverse();
  for (const Isometry& g : frame_.cosets) cosets_in_instance_.push_back(to_instance_ * g * back);
}

namespace {

template <int D>
std::vector<std::array<Element, 4>> cells_of_the_origin(const PreparedGroup& group) {
  const std::vector<Site> sites =
      make_sites(group.frame(), group.site_maps(), {group.to_instance().translation});
  Predicates<D> predicates(group.frame(), group.table(), sites, group.order(), PredicateStages::filtered,
                           group.integral_metric<D>());
  std::vector<std::array<Element, 4>> result;
  for (const CellPoints<D>& cell : triangulate_first_orbit<D>(group.frame(), group.table(), sites,
                                                              group.order(), predicates, SiteId{0})) {
    std::array<Element, 4>& elements = result.emplace_back();
    for (std::size_t k = 0; k <= D; ++k) elements[k] = cell[k].g;
  }
  return result;
}

}  // namespace

const std::vector<std::array<Element, 4>>& PreparedGroup::lattice_cells() const {
  std::call_once(lattice_once_, [this] {
    if (table_.cosets() > 1) return;
    lattice_cells_ = frame_.dimension == 2 ? cells_of_the_origin<2>(*this) : cells_of_the_origin<3>(*this);
  });
  return lattice_cells_;
}

const Sublattice& PreparedGroup::complete_orbit_cover() const {
  std::call_once(cover_once_, [this] { cover_ = ref::complete_orbit_cover(frame_); });
  return *cover_;
}

Isometry PreparedGroup::in_instance(std::uint16_t coset,
                                    const std::array<std::int64_t, 3>& translation) const {
  Isometry element = cosets_in_instance_[coset];
  for (int j = 0; j < frame_.dimension; ++j) {
    const long t = translation[static_cast<std::size_t>(j)];
    if (t == 0) continue;
    for (int i = 0; i < frame_.dimension; ++i) element.translation[i].add_multiple(t, frame_.basis(i, j));
  }
  return element;
}

}  // namespace flatdt::ref
