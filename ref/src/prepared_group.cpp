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
    std::get<0>(predicates_) = std::make_unique<const PredicateConstants<2>>(frame_, table_);
    std::get<0>(circumradii_) = std::make_shared<const CircumradiusConstants<2>>(frame_);
  } else {
    std::get<1>(predicates_) = std::make_unique<const PredicateConstants<3>>(frame_, table_);
    std::get<1>(circumradii_) = std::make_shared<const CircumradiusConstants<3>>(frame_);
  }
  const Isometry back = to_instance_.inverse();
  for (const Isometry& g : frame_.cosets) cosets_in_instance_.push_back(to_instance_ * g * back);
}

template <int D>
const QuotientComplex<D>* PreparedGroup::lattice_complex() const {
  auto& complex = std::get<std::unique_ptr<const QuotientComplex<D>>>(lattice_complexes_);
  std::call_once(lattice_once_, [&] {
    if (table_.cosets() > 1) return;
    lattice_site_ = make_sites(frame_, site_maps_, {to_instance_.translation});
    Predicates<D> predicates(predicate_constants<D>(), table_, lattice_site_, order_,
                             PredicateStages::filtered);
    auto made = std::make_unique<QuotientComplex<D>>(table_, lattice_site_, order_.invariance_group());
    made->add_site(SiteId{0});
    made->assemble(triangulate_first_orbit<D>(frame_, table_, lattice_site_, order_, predicates, SiteId{0}),
                   predicates);
    complex = std::move(made);
  });
  return complex.get();
}

template const QuotientComplex<2>* PreparedGroup::lattice_complex<2>() const;
template const QuotientComplex<3>* PreparedGroup::lattice_complex<3>() const;

const Sublattice& PreparedGroup::complete_orbit_cover() const {
  std::call_once(cover_once_, [this] { cover_ = ref::complete_orbit_cover(frame_); });
  return *cover_;
}

const Subgroup& PreparedGroup::complete_orbit_subgroup() const {
  std::call_once(cover_subgroup_once_,
                 [this] { cover_subgroup_ = Subgroup::sublattice(table_, complete_orbit_cover()); });
  return *cover_subgroup_;
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
