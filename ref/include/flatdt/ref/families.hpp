/// Named families of point sets on the twelve manifolds: uniform ones and ones built to be degenerate, skew,
/// long or far away.
/// Invariants: all coordinates are exact rationals; the instance is a function of the arguments alone, on
/// every machine (integer arithmetic only, one generator of random numbers fixed here).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/instance.hpp"

namespace flatdt::ref {

struct Family {
  std::string name;
  std::string description;  // one line
};

/// All families, in the order of the documentation.
const std::vector<Family>& families();

inline constexpr long kMaxGeneratedPoints = 100'000'000;  // FORMAT: limits

/// An instance of a family on the manifold `entry`, claimed under `name` (the entry's name or an alias; P32,
/// P43 and P65 mean the mirror image).
/// Laws:    n points, pairwise in different orbits except in the family single-orbit; analyse() accepts the
///          instance; the same arguments give the same instance.
/// metric:  "canonical" (the catalogue's) or "random": a random point of the catalogue's cone of Gram
///          matrices with axis ratio up to about 2, in multiples of 1/384. The family long-cell stretches it.
/// Errors:  InvalidInput for an unknown family or metric and for n outside [1, kMaxGeneratedPoints].
/// Complexity: O(n log n) exact operations.
Instance generate(const CatalogueEntry& entry, std::string_view name, std::string_view family, long n,
                  std::uint64_t seed, std::string_view metric = "canonical");

}  // namespace flatdt::ref
