#include "flatdt/ref/prepared_group.hpp"

#include <algorithm>
#include <string>

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
      to_instance_{frame_.basis, frame_.origin} {
  const Isometry back = to_instance_.inverse();
  for (const Isometry& g : frame_.cosets) cosets_in_instance_.push_back(to_instance_ * g * back);
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
