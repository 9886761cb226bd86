/// The distinct points of the manifold: one site per orbit, with exact and floating-point coordinates in the
/// frame. Invariants: sites are numbered in the order of their canonical representatives c, the lexicographic
/// minimum of r p mod 1 over the coset representatives r in catalogue coordinates; so SiteId is the orbit's
/// rank in the tie order. A site's coordinates d are those of c in the frame, reduced into [0,1)^d. Source:
/// INSERTION, "Order"; it makes everything a function of the points of E^d/G alone.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flatdt/ref/group_table.hpp"

namespace flatdt::ref {

enum class SiteId : std::uint32_t {};
constexpr std::uint32_t index_of(SiteId id) {
  return static_cast<std::uint32_t>(id);
}

struct Site {
  /// Coordinates = numerators / denominator, in [0,1); the denominator is a multiple of the frame's
  /// translation_denominator.
  std::array<mpz_class, 3> numerators;
  mpz_class denominator;
  /// The coordinates rounded towards zero: error below 2^-52.
  std::array<double, 3> approximate{};
  /// The least index of an input point in this orbit, and the element (frame coordinates) with
  /// p = from_site * site.
  std::uint32_t point = 0;
  Isometry from_site{Matrix(0), Vector(0)};
};

/// Builds the sites of an instance's points. Points in one orbit give one site.
/// Errors: LimitReached if a denominator has more than 8,192 bits.
/// Complexity: O(n log n) exact comparisons.
std::vector<Site> make_sites(const Frame& frame, const std::vector<Vector>& points);

}  // namespace flatdt::ref
