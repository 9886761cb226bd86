/// The checkerboard of cubes cut into five cells.
#pragma once

#include "edit.hpp"

namespace flatdt::edits {

/// The grid (1/k)Z^3 modulo Z^3, k odd: every cube cut into five, the one in the middle on the corners with
/// an even sum of coordinates. Invariant under index 2 of Z^3 only; the cells modulo that are a connected
/// double cover.
/// Nothing if the base is not such a grid.
[[nodiscard]] std::optional<Files> checkerboard(const Base& base, Random& random);

}  // namespace flatdt::edits
