/// What FORMAT.md asks of a group: torsion, the first homology of its quotient, and the name of that.
#pragma once

#include <string>

#include "naive_checker/abelian.hpp"
#include "oracle/group.hpp"

namespace flatdt::naive {

/// Only the identity has a fixed point. (An element with a fixed point has finite order, as its powers are
/// determined by their linear parts; one of finite order fixes the barycentre of an orbit.)
[[nodiscard]] bool is_torsion_free(const oracle::Group& group);

/// G / [G, G].
[[nodiscard]] AbelianGroup first_homology(const oracle::Group& group);

/// The canonical name of E^d / G, from (dimension, orientable, order of the holonomy group, first homology).
/// Requires: is_torsion_free(group). Errors: std::logic_error if it is none of the twelve.
[[nodiscard]] std::string manifold_name(const oracle::Group& group);

}  // namespace flatdt::naive
