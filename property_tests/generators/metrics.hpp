/// Gram matrices that a group preserves, in catalogue coordinates.
#pragma once

#include <vector>

#include "flatdt/ref/isometry.hpp"
#include "random.hpp"

namespace flatdt::testing {

/// One element for each linear part of the group that the generators and Z^d generate, the identity first,
/// translations in [0,1)^d.
/// Requires: a catalogue group (at most 6 linear parts, translation lattice Z^d).
std::vector<ref::Isometry> cosets_of(const std::vector<ref::Isometry>& generators);

/// The mean of R^T M R over the linear parts: positive definite if M is, and invariant.
ref::Matrix averaged(const ref::Matrix& m, const std::vector<ref::Isometry>& cosets);
bool is_admissible(const ref::Matrix& gram, const std::vector<ref::Isometry>& cosets);

/// One of: the canonical metric, a random one with entries in small fractions, the canonical one moved by
/// 2^-k inside the cone of invariant metrics (so that ties become near-ties), a stretched one. Scaled by a
/// random factor.
ref::Matrix draw_metric(const ref::Matrix& canonical, const std::vector<ref::Isometry>& cosets,
                        long max_stretch, Random& random);

/// Each class of axes that the group mixes scaled by an integer from 1 to max_stretch.
ref::Matrix stretched_metric(const ref::Matrix& gram, const std::vector<ref::Isometry>& cosets,
                             long max_stretch, Random& random);

}  // namespace flatdt::testing
