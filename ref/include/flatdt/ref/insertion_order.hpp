/// The order in which a batch of orbits is inserted.
#pragma once

#include <vector>

#include "flatdt/ref/sites.hpp"

namespace flatdt::ref {

/// A biased randomized insertion order: random rounds, each seven times as large as all before it, and within
/// a round the order of a space-filling curve, so that each point lies near the one before it and no
/// hierarchy is needed to find it. Law: a permutation of the sites; a function of the sites, the metric and
/// the seed. Complexity: O(n log n). Source: [AmentaChoiRote03]; the curve is Hilbert's, in coordinates of
/// the frame scaled by the lengths of its axes [Skilling04].
std::vector<SiteId> batch_order(const Frame& frame, const std::vector<Site>& sites, std::uint64_t seed);

}  // namespace flatdt::ref
