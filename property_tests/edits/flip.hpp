/// Bistellar flips of a valid triangulation modulo H: the other triangulation of d+2 points in convex
/// position.
///
/// A flip keeps the tiling: the cells that go and those that come fill the same polytope, which is embedded
/// modulo H. If the points are on one sphere, the new cells are as good as the old. If not, the old cells are
/// the lower faces of the lifted points and the new ones the upper: then every new facet inside the polytope
/// is not Delaunay.
#pragma once

#include "draft.hpp"

namespace flatdt::edits {

struct Flip {
  std::vector<std::size_t> gone;  ///< numbers of the cells that go
  std::vector<FileCell> come;     ///< cells that take their place
  bool tie = false;               ///< all points are on one sphere
  bool adds_edge = false;         ///< 2-2, 2-3 and 4-4 add the edge (from, to); 3-2 adds none
  ref::Vector from{0}, to{0};
};

/// Across the facet opposite to a corner: 2-2 in the plane, 2-3 in space. Nothing where the edge between the
/// apices does not cross the interior of the facet.
[[nodiscard]] std::optional<Flip> facet_flip(const Base& base, Draft& draft, std::size_t cell,
                                             std::size_t corner);

/// About the edge opposite to two corners of a cell, if three cells are there: 3-2. Requires: dimension 3.
[[nodiscard]] std::optional<Flip> edge_flip(const Base& base, Draft& draft, std::size_t cell, std::size_t k,
                                            std::size_t l);

/// Where the two apices of a facet and two of its corners p, q are the corners of a flat convex
/// quadrilateral: the two cells are cut along its other diagonal, and
/// - if `filled`: a flat cell joins them to the cells below, which stay as they are;
/// - else: the two cells below are cut too, if there are only two (4-4).
/// Requires: dimension 3.
[[nodiscard]] std::optional<Flip> quadrilateral_flip(const Base& base, Draft& draft, std::size_t cell,
                                                     std::size_t corner, bool filled);

/// Carries out a flip.
void apply(const Flip& flip, Draft& draft);

}  // namespace flatdt::edits
