/// The distinct points of the manifold: one site per orbit, with exact and floating-point coordinates in the
/// frame. Invariants: sites are numbered in the order of their canonical representatives c, the lexicographic
/// minimum of r p mod 1 over the coset representatives r in catalogue coordinates; so SiteId is the orbit's
/// rank in the tie order. A site's coordinates d are those of c in the frame, reduced into [0,1)^d. Source:
/// INSERTION, "Order"; it makes everything a function of the points of E^d/G alone.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "flatdt/ref/group_table.hpp"

namespace flatdt::ref {

enum class SiteId : std::uint32_t {};
constexpr std::uint32_t index_of(SiteId id) {
  return static_cast<std::uint32_t>(id);
}

/// What does not fit the fixed fields of a site.
struct LargeSite {
  std::array<mpz_class, 3> numerators;
  mpz_class denominator;
  std::array<double, 3> approximate{};
  Isometry from_site;
};

/// What sites have in common with others: of many points few forms are different.
/// Invariant: either `large` is set and holds all of one site, or small_denominator > 0.
struct SiteForm {
  /// Below 2^62, a multiple of the frame's translation_denominator, and the same for all sites that have one.
  std::int64_t small_denominator = 0;
  /// The element of the group with p = element * site: a coset of the frame and the integral translation
  /// after its representative.
  std::uint16_t coset = 0;
  std::array<std::int32_t, 3> translation{};
  std::unique_ptr<const LargeSite> large;
};

/// 48 bytes.
struct Site {
  /// Unless it is large, coordinates = small / form->small_denominator, in [0,1).
  std::array<std::int64_t, 3> small{};
  std::shared_ptr<const SiteForm> form;
  /// The least index of an input point in this orbit.
  std::uint32_t point = 0;

  [[nodiscard]] bool is_large() const { return form->large != nullptr; }
  [[nodiscard]] Integer numerator(int i) const {
    const auto k = static_cast<std::size_t>(i);
    return is_large() ? Integer(form->large->numerators[k]) : Integer(static_cast<long>(small[k]));
  }
  [[nodiscard]] Integer denominator() const {
    return is_large() ? Integer(form->large->denominator)
                      : Integer(static_cast<long>(form->small_denominator));
  }
  /// The coordinates rounded: error below 2^-51. Divides: to be kept where it is needed often.
  [[nodiscard]] std::array<double, 3> approximate() const {
    if (is_large()) return form->large->approximate;
    const auto denominator = static_cast<double>(form->small_denominator);
    return {static_cast<double>(small[0]) / denominator, static_cast<double>(small[1]) / denominator,
            static_cast<double>(small[2]) / denominator};
  }
  /// The element (frame coordinates) with p = from_site * site.
  [[nodiscard]] Isometry from_site(const Frame& frame) const;
};

/// The maps that make_sites applies to every point; they depend on the frame alone.
struct SiteMaps {
  explicit SiteMaps(const Frame& frame);
  Isometry to_catalogue;    // of instance coordinates
  Isometry from_catalogue;  // to the frame; linear
  std::vector<Isometry> catalogue_cosets;
  std::vector<std::uint16_t> inverse_coset;
};

/// The same as the next, with maps that are made once for many point sets.
std::vector<Site> make_sites(const Frame& frame, const SiteMaps& maps, const std::vector<Vector>& points);

/// Builds the sites of an instance's points. Points in one orbit give one site.
/// Errors: LimitReached if a denominator has more than 8,192 bits.
/// Complexity: O(n log n) exact comparisons.
std::vector<Site> make_sites(const Frame& frame, const std::vector<Vector>& points);

}  // namespace flatdt::ref
