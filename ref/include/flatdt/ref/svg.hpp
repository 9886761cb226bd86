/// Pictures of triangulations of flat surfaces: one self-contained SVG document.
/// Invariants: the bytes are a function of the arguments (no time, path or locale; doubles are only used to
/// place shapes, with operations that IEEE 754 rounds correctly); whatever parses is drawn or refused,
/// however wrong the triangulation is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/refutation.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::ref {

struct DrawingOptions {
  bool show_two_cycle = false;
  bool show_violation = false;
  /// What a judge said; the witness of one failing condition is shown.
  std::optional<Verdict> verdict = std::nullopt;
  /// Which; empty: the first that has a figure.
  std::string condition = {};
  /// Faded copies around the fundamental domain.
  bool show_copies = true;
};

struct Drawing {
  std::string svg;
  /// What was found or left out: one sentence each, also in the picture's description.
  std::vector<std::string> notes;
};

/// Draws a fundamental domain of H with the triangulation of E^2/H in it (the cells whose barycentre is in
/// it), arrows on the sides that are glued, copies around it (faded, those that H turns over in another
/// shade), and the points with their indices. show_two_cycle: marks the first edge (in the order of the
/// cells) whose ends are one vertex modulo the full group G, else the first two different edges modulo G with
/// the same ends. show_violation: marks the first cell whose circumdisk has a point of the instance strictly
/// inside, with the deepest such point (exactly decided). verdict: marks what the witness names, as it was
/// given; if a facet does not occur twice, also the other cells at it. If the subgroup of the triangulation
/// is not admissible, only the listed cells are drawn, and a note says so. Errors: InvalidInput if the
/// dimension is not 2, analyse() refuses the instance, or the condition asked for does not fail; LimitReached
/// above kMaxDrawnCells copies of cells in view.
Drawing draw_svg(const Instance& instance, const Triangulation& triangulation, const DrawingOptions& options);

inline constexpr std::size_t kMaxDrawnCells = 200'000;

}  // namespace flatdt::ref
