// Faces modulo H by canonical keys, and the facets with the cells on their sides.
//
// Key: a face has vertices (v_i, h_i); moving it by h_b^-1 puts vertex b to its base lift. Of all b with
// least v_b take the least sorted list of (v_i, h_b^-1 h_i). H acts freely on the plane or space, so equal
// faces modulo H have equal keys, the mover h_b^-1 is determined by the face, and the first entry of the list
// is (v_b, identity). Source: DESIGN.md, section 6; docs/soundness.md, section 3.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "complex.hpp"
#include "flatdt/checker/exact.hpp"

namespace flatdt::checker {

inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// The canonical sorted list of a face: vertices, and offsets of all but the first; unused entries are kNone.
struct FaceKey {
  std::array<std::uint32_t, 4> vertex{kNone, kNone, kNone, kNone};
  std::array<std::uint32_t, 3> offset{kNone, kNone, kNone};

  auto operator<=>(const FaceKey&) const = default;
};

/// A face of one cell in canonical form: list entry k is corner[k] of the cell, and corner[0] has the base
/// lift.
struct CanonicalFace {
  FaceKey key;
  std::array<std::uint8_t, 4> corner{};
};

/// The face of `cell` spanned by the first `size` entries of `corners`.   Requires: those vertices are
/// different.
[[nodiscard]] CanonicalFace canonical_face(const Cell& cell, const std::array<std::uint8_t, 4>& corners,
                                           std::size_t size);

/// The sorted distinct faces with `size` vertices of all cells. Subsets with a repeated vertex are no such
/// faces.
[[nodiscard]] std::vector<FaceKey> distinct_faces(const Complex& complex, std::size_t size);

/// Whether two corners of the cell are the same point.
[[nodiscard]] bool has_repeated_vertex(const Cell& cell, std::size_t corners);

/// One facet of one cell.
struct Occurrence {
  FaceKey key;
  CellId cell;
  std::uint8_t facet;  ///< the corner opposite
  std::uint8_t base;   ///< the corner with the base lift in the canonical list
  std::int8_t parity;  ///< of the permutation (canonical list, apex) of the cell's corners
};

/// All occurrences, sorted by key, then cell and facet. Cells with a repeated vertex have none.
[[nodiscard]] std::vector<Occurrence> facet_occurrences(const Complex& complex);

}  // namespace flatdt::checker
