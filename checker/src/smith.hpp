// Diagonal form of integer matrices, and the finitely generated abelian groups read off it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "flatdt/checker/exact.hpp"

namespace flatdt::checker {

using Rows = std::vector<std::vector<Integer>>;

/// Z^betti + Z/t_1 + ... + Z/t_k with 1 < t_1 | t_2 | ... | t_k.
struct AbelianGroup {
  std::size_t betti = 0;
  std::vector<Integer> torsion;

  bool operator==(const AbelianGroup&) const = default;
};

/// "Z^2+Z/2", "Z", "0".
[[nodiscard]] std::string to_string(const AbelianGroup& group);

/// Brings the first `width` columns to diagonal form by unimodular row and column operations, and returns the
/// diagonal (not negative, nonzero entries first). Columns from `width` on follow the row operations only:
/// appending the identity yields the row transformation.
std::vector<Integer> diagonalise(Rows& rows, std::size_t width);

/// The abelian group of `generators` generators with one relation per row.
[[nodiscard]] AbelianGroup abelian_group(std::size_t generators, Rows relations);

}  // namespace flatdt::checker
