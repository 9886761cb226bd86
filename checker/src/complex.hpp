// The cells modulo H as a complex in which every vertex is a lift: a vertex modulo H and an element of H.
//
// Invariants: for vertices i, j of a cell, offset[i][j] = h_i^-1 h_j, where h_i * (base lift of vertex[i]) is
// the i-th vertex. So (vertex[j], offset[i][j]) for all j is the cell moved by H until its i-th vertex is a
// base lift. Few of these tables are different, so each is stored once: shape 0 is that of the cells whose
// vertices are all moved by one h.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "elements.hpp"
#include "flatdt/checker/ids.hpp"
#include "flatdt/checker/input.hpp"
#include "orbits.hpp"
#include "subgroup.hpp"

namespace flatdt::checker {

using Offsets = std::array<std::array<ElementId, 4>, 4>;

struct Cell {
  std::array<VertexId, 4> vertex;
  std::uint32_t shape;  ///< of Complex::shapes
  ElementId anchor;  ///< h_0: moves the normalised cell (frame of its first vertex) to the cell of the file
};

/// A vertex modulo H: the right coset H*coset of an orbit; its base lift is coset * canonical point of the
/// orbit.
struct Vertex {
  OrbitId orbit;
  ElementId coset;
};

struct Complex {
  std::size_t corners;  ///< d + 1
  std::vector<Vertex> vertices;
  std::vector<Cell> cells;
  std::vector<Offsets> shapes;
  std::vector<std::uint8_t> reversing;  ///< by shape: bit j is set iff offset[0][j] reverses orientation
  bool has_reversing = false;           ///< whether some bit is set

  [[nodiscard]] const Offsets& offsets(const Cell& cell) const { return shapes[cell.shape]; }
  /// Whether moving the normalised cell into the frame of a corner reverses its orientation.
  [[nodiscard]] bool reverses(const Cell& cell, std::size_t corner) const {
    return has_reversing && (reversing[cell.shape] >> corner & 1U) != 0;
  }
};

/// Translates the cells of the file.
/// Requires: elements[k] is the id of the k-th listed element.
/// Cost:     expected linear in the cells; at worst that of an IdMap for each.
[[nodiscard]] Complex make_complex(const Triangulation& triangulation, const std::vector<ElementId>& elements,
                                   const Orbits& orbits, const Subgroup& subgroup, ElementTable& table);

}  // namespace flatdt::checker
