/// Sites of points whose numbers are small, in machine integers, and of any points, in rationals.
#pragma once

#include <optional>
#include <vector>

#include "flatdt/ref/sites.hpp"

namespace flatdt::ref {

/// The sites in the small form, or nothing where some number does not fit: a denominator common to all points
/// below 2^62 in the frame, coordinates below 2^62 over it before they are reduced, translations below 2^31.
/// Complexity: O(n log n) machine operations.
std::optional<std::vector<Site>> make_small_sites(const Frame& frame, const SiteMaps& maps,
                                                  const std::vector<Vector>& points);

/// The sites in the large form. Same order, coordinates and elements as the small form. Errors: make_sites'.
std::vector<Site> make_general_sites(const Frame& frame, const SiteMaps& maps,
                                     const std::vector<Vector>& points);

}  // namespace flatdt::ref
