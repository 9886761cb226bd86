/// Steepest descent to the closest lattice vector, shared by reduction and closest vectors.
/// Source: [McKilliamGrantClarkson14] for the number of steps.
#pragma once

#include <vector>

#include "flatdt/ref/linear.hpp"

namespace flatdt::ref {

/// The sums of all nonempty proper subsets of an obtuse superbase v_0..v_d (v_0 + .. + v_d = 0): 6 vectors in
/// 2D, 14 in 3D; the negative of each is among them. They contain the Voronoi-relevant vectors of the
/// lattice. Source: [ConwaySloane92].
std::vector<Vector> proper_subset_sums(const std::vector<Vector>& superbase);

/// x - s for a lattice vector s closest to x: subtracts the n of `relevant` that shortens x most, while
/// 2 <x,n> > <n,n> for some n.
/// Requires: relevant = proper_subset_sums of an obtuse superbase. Gram may be that of a larger space: then s
/// is closest to the projection of x on the span of the superbase.
/// Complexity: at most d steps when the coordinates of x in v_1..v_d are in [0,1)
/// [McKilliamGrantClarkson14].
Vector descend(const Matrix& gram, const std::vector<Vector>& relevant, Vector x);

}  // namespace flatdt::ref
