/// Pictures of triangulations of flat surfaces: one self-contained SVG document.
/// Invariants: the bytes are a function of the arguments (no time, path or locale; doubles are only used to
/// place shapes, with operations that IEEE 754 rounds correctly); whatever parses is drawn or refused,
/// however wrong the triangulation is.
#pragma once

#include <string>
#include <vector>

#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::ref {

struct DrawingOptions {
  bool show_two_cycle = false;
  bool show_violation = false;
};

struct Drawing {
  std::string svg;
  /// What was found or left out: one sentence each, also in the picture's description.
  std::vector<std::string> notes;
};

/// Draws the fundamental cell of the reduced translation lattice of E^2/H with the triangulation in it,
/// copies around it (faded), and the points with their indices. show_two_cycle: marks the first edge (in the
/// order of the cells) whose ends are one vertex modulo the full group G, else the first two different edges
/// modulo G with the same ends. show_violation: marks the first cell whose circumdisk has a point of the
/// instance strictly inside, with the deepest such point (exactly decided). If the subgroup of the
/// triangulation is not admissible, only the listed cells are drawn, and a note says so. Errors: InvalidInput
/// if the dimension is not 2 or analyse() refuses the instance; LimitReached above kMaxDrawnCells copies of
/// cells in view.
Drawing draw_svg(const Instance& instance, const Triangulation& triangulation, const DrawingOptions& options);

inline constexpr std::size_t kMaxDrawnCells = 200'000;

}  // namespace flatdt::ref
