/// What depends on the group and the metric alone, made once for many point sets.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

#include "flatdt/ref/circumradius.hpp"
#include "flatdt/ref/cover.hpp"
#include "flatdt/ref/tie_order.hpp"

namespace flatdt::ref {

/// Neither copied nor moved: its parts refer to one another. May be used by several threads at a time.
class PreparedGroup {
 public:
  /// Errors: LimitReached if an entry of the metric of the reduced lattice has a numerator or denominator of
  /// more than 4,608 bits, which covers exponents down to 10^-1100 and 2^-4400: the predicates take products.
  explicit PreparedGroup(const GroupAnalysis& analysis);
  PreparedGroup(const PreparedGroup&) = delete;
  PreparedGroup& operator=(const PreparedGroup&) = delete;
  ~PreparedGroup() = default;

  [[nodiscard]] const Frame& frame() const { return frame_; }
  [[nodiscard]] const GroupTable& table() const { return table_; }
  [[nodiscard]] const TieOrder& order() const { return order_; }
  /// The smallest cover that is safe for complete orbits; found at the first call.
  [[nodiscard]] const Sublattice& complete_orbit_cover() const;
  /// Its translations; made at the first call.
  [[nodiscard]] const Subgroup& complete_orbit_subgroup() const;

  [[nodiscard]] const SiteMaps& site_maps() const { return site_maps_; }
  /// Requires: D is the group's dimension.
  template <int D>
  [[nodiscard]] const PredicateConstants<D>& predicate_constants() const {
    return *std::get<std::unique_ptr<const PredicateConstants<D>>>(predicates_);
  }
  /// For the circumradii of the group's dimension D; null for the other.
  template <int D>
  [[nodiscard]] const std::shared_ptr<const CircumradiusConstants<D>>& circumradius_constants() const {
    return std::get<std::shared_ptr<const CircumradiusConstants<D>>>(circumradii_);
  }
  /// DT(Gq) of a point q on a torus, whose cells are the same for each q; null for other groups. Found at the
  /// first call. Requires: D is the group's dimension.
  template <int D>
  [[nodiscard]] const QuotientComplex<D>* lattice_complex() const;

  /// An element of the frame, {translation} * coset, as an element of the instance's group.
  /// Complexity: a few additions of rationals.
  [[nodiscard]] Isometry in_instance(std::uint16_t coset,
                                     const std::array<std::int64_t, 3>& translation) const;
  /// The map from frame coordinates to the instance's.
  [[nodiscard]] const Isometry& to_instance() const { return to_instance_; }

 private:
  Frame frame_;
  GroupTable table_;
  TieOrder order_;
  Isometry to_instance_;
  std::vector<Isometry> cosets_in_instance_;
  SiteMaps site_maps_;
  std::tuple<std::unique_ptr<const PredicateConstants<2>>, std::unique_ptr<const PredicateConstants<3>>>
      predicates_;
  std::tuple<std::shared_ptr<const CircumradiusConstants<2>>, std::shared_ptr<const CircumradiusConstants<3>>>
      circumradii_;
  mutable std::once_flag lattice_once_;
  mutable std::vector<Site> lattice_site_;
  mutable std::tuple<std::unique_ptr<const QuotientComplex<2>>, std::unique_ptr<const QuotientComplex<3>>>
      lattice_complexes_;
  mutable std::once_flag cover_once_;
  mutable std::optional<Sublattice> cover_;
  mutable std::once_flag cover_subgroup_once_;
  mutable std::optional<Subgroup> cover_subgroup_;
};

extern template const QuotientComplex<2>* PreparedGroup::lattice_complex<2>() const;
extern template const QuotientComplex<3>* PreparedGroup::lattice_complex<3>() const;

}  // namespace flatdt::ref
