// From generators to the point group and the translation lattice.
#pragma once

#include <variant>
#include <vector>

#include "flatdt/checker/exact.hpp"
#include "flatdt/checker/verdict.hpp"
#include "lattice.hpp"

namespace flatdt::checker {

/// A group of affine maps with finitely many linear parts: representatives, one for each linear part,
/// identity first, and the lattice of its translations. The group is the union of lattice * representative.
struct Crystal {
  int dimension;
  std::vector<Seitz> representatives;
  Lattice lattice;
};

/// The group that `generators` generate.
/// Returns:  the crystal, or the witness that the linear parts are no crystallographic point group: one does
/// not keep
///           `metric` (if given), has infinite order, or is one of more than 12 (2D) or 48 (3D).
/// Method:   closure of the linear parts under the generators that enlarge it; Schreier's generators of the
/// kernel of
///           g -> linear part; every other generator differs from a representative by a translation, which is
///           added together with its images under the point group. docs/soundness.md, section 2.
/// Errors:   ResourceLimit above kMaxGroupBits.   Cost: bounded by the limits; O(generators) lattice
/// operations.
[[nodiscard]] std::variant<Crystal, Witness> close_group(int dimension, const std::vector<Seitz>& generators,
                                                         const Mat<Rational>* metric);

}  // namespace flatdt::checker
