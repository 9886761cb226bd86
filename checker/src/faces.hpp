// Faces modulo H by canonical lists, and the facets with the cells on their sides.
//
// List: a face has vertices (v_i, h_i); moving it by h_b^-1 puts vertex b to its base lift. Of all b with
// least v_b take the least sorted list of (v_i, h_b^-1 h_i). H acts freely on the plane or space, so equal
// faces modulo H have equal lists, the mover h_b^-1 is determined by the face, and the first entry of the
// list is (v_b, identity). Source: DESIGN.md, section 6; docs/soundness.md, section 3.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "complex.hpp"

namespace flatdt::checker {

inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// The canonical list of a face: vertices, and offsets of all but the first; unused entries are kNone.
struct FaceKey {
  std::array<std::uint32_t, 4> vertex{kNone, kNone, kNone, kNone};
  std::array<std::uint32_t, 3> offset{kNone, kNone, kNone};

  auto operator<=>(const FaceKey&) const = default;  // NOLINT(modernize-use-nullptr): none is written
};

/// The corners of a face in the order of its canonical list; corner [0] has the base lift.
using Corners = std::array<std::uint8_t, 4>;

/// The face of `cell` spanned by the first `size` entries of `corners`, which are put into the order of the
/// list. Requires: those vertices are different.
void make_canonical(const Cell& cell, const Offsets& offset, Corners& corners, std::size_t size);

/// The list of a face whose corners are in its order.
[[nodiscard]] FaceKey key_of(const Cell& cell, const Offsets& offset, const Corners& corners,
                             std::size_t size);

/// Whether two of the first `size` of these corners are the same point.
[[nodiscard]] bool repeats_vertex(const Cell& cell, const Offsets& offset, const Corners& corners,
                                  std::size_t size);

/// One facet of one cell.
struct Occurrence {
  CellId cell;
  std::uint8_t facet;  ///< the corner opposite
  std::uint8_t base;   ///< the corner with the base lift in the canonical list
  std::int8_t parity;  ///< of the permutation (canonical list, apex) of the cell's corners
};

/// The corners of the cell but `facet`, in ascending order.
[[nodiscard]] Corners side_corners(const Complex& complex, std::uint8_t facet);

/// The corners of a facet in the order of its canonical list.
[[nodiscard]] Corners facet_corners(const Complex& complex, const Occurrence& occurrence);

/// The canonical list of a facet.   Requires: its vertices are different.
[[nodiscard]] FaceKey key_of_facet(const Complex& complex, const Occurrence& occurrence);

/// The two occurrences of one facet, the one in the smaller cell (then of the smaller corner) first.
struct FacetPair {
  Occurrence first;
  Occurrence second;
};

/// The canonical list of an edge: (low, identity), (high, offset).
struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t offset;

  auto operator<=>(const Edge&) const = default;  // NOLINT(modernize-use-nullptr): none is written
  [[nodiscard]] FaceKey key() const { return {{low, high, kNone, kNone}, {offset, kNone, kNone}}; }
};

/// The faces of all cells, each in the order of the canonical lists. Subsets of a cell's corners with a
/// repeated vertex are no faces. The sides of a cell with such a subset are not among the facets, but they
/// are occurrences: a facet that has two others is not paired.
struct Faces {
  /// A facet that does not occur exactly twice: its first occurrence, and their number.
  struct Odd {
    Occurrence first;
    std::size_t occurrences;
  };
  using Parallel = std::array<FaceKey, 2>;  ///< two different faces with the same vertices
  /// A vertex whose link is no sphere; without meaning if a cell has a repeated vertex or a facet is odd.
  struct BadLink {
    VertexId vertex;
    const char* reason;
    std::size_t cells;
    std::size_t vertices;
  };

  std::vector<Edge> edges;        ///< distinct
  std::vector<FacetPair> pairs;   ///< facets that occur exactly twice
  std::optional<Odd> odd;         ///< the first one that does not
  std::vector<CellId> flattened;  ///< cells with a repeated vertex, in ascending order
  /// The cells that are listed earlier as well, in ascending order; complete unless a facet is odd.
  /// Law: the two occurrences of a facet have the same apex in the frame of the list iff they are of one
  /// cell.
  std::vector<CellId> repeated_cells;
  std::array<std::size_t, 5> count{};  ///< distinct faces, by number of vertices, 2 to d+1
  std::array<std::optional<Parallel>, 4>
      parallel;                     ///< the first such edges, in 3D such facets, by number of vertices
  std::optional<BadLink> bad_link;  ///< the first one
};

/// Cost: O(n log m) for n cells, m the largest number of faces at one vertex.
/// `jobs`: threads; the faces are the same.
[[nodiscard]] Faces find_faces(const Complex& complex, unsigned jobs = 1);

}  // namespace flatdt::checker
