/// Point sets of the benchmarks: doubles, so that every program gets the same numbers, and exact rationals
/// made of them. Invariants: a function of the arguments alone, on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "flatdt/ref/instance.hpp"

namespace flatdt::bench {

/// The first d coordinates count; the others are 0.
using Point = std::array<double, 3>;

/// Points of the torus of d translations by `period` along the axes.
struct PointSet {
  int dimension = 3;
  double period = 1;
  std::vector<Point> points;
};

/// uniform:      n independent points of [0,1)^d, multiples of 2^-53; the only set that depends on the seed.
/// rounded-grid: i/k in every coordinate, rounded to double: almost cospherical everywhere, or exactly.
/// integer-grid: i in every coordinate, period k.
/// k is the root of n rounded to the nearest, so that a grid has k^d points, 46^3 for n = 100,000.
/// Errors: std::invalid_argument for another name.
PointSet point_set(std::string_view name, int dimension, std::size_t n, std::uint64_t seed = 1);

/// The set as an instance on the torus.
ref::Instance torus_instance(const PointSet& set);

/// The first coordinates of uniform(n) as orbits of a catalogued manifold at its canonical metric: all of the
/// translation lattice's unit cell is used, so representatives of different copies.
ref::Instance uniform_instance(std::string_view manifold, std::size_t n, std::uint64_t seed = 1);

/// A family of the reference, canonical metric, seed 1.
ref::Instance family_instance(std::string_view manifold, std::string_view family, std::size_t n);

/// n points that are uniform in a cell whose axes i are stretched by stretch[i] (integers).
/// Requires: the metric stays invariant under the group (admits_stretch).
ref::Instance stretched_instance(std::string_view manifold, const std::array<long, 3>& stretch, std::size_t n,
                                 std::uint64_t seed = 1);
bool admits_stretch(std::string_view manifold, const std::array<long, 3>& stretch);

}  // namespace flatdt::bench
