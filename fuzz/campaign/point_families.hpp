/// Families of point sets that stress what programs do in covering spaces: bands, nearly regular grids, and
/// grids that let a program leave its covering space. Coordinates are the catalogue's. Laws: as
/// testing::draw_specimen: a function of the arguments alone.
#pragma once

#include <string>
#include <vector>

#include "flatdt/ref/linear.hpp"
#include "random.hpp"

namespace flatdt::campaign {

/// - thin-band: one coordinate in a band of width 2^-2 to 2^-40, the others uniform;
/// - jittered-grid: n places of the coarsest grid with so many, each moved by a multiple of 2^-k, k from 3 to
///   48;
/// - filled-grid: all places of the finest grid with at most n, moved likewise or not at all, and uniform
///   points between them: edges are short, so that programs leave their covering space on the way;
/// - integer-grid: different multiples of 1/m, m a little larger than needed, half of the time a power of
/// two.
[[nodiscard]] const std::vector<std::string>& own_families();

/// n points of an own family. Requires: family is one of own_families(), n >= 1.
/// Cost: O(n) exact operations, and O(grid) for grids.
[[nodiscard]] std::vector<ref::Vector> draw_points(const std::string& family, int dimension, long n,
                                                   testing::Random& random);

}  // namespace flatdt::campaign
