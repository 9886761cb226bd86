/// The verdict of a judge of triangulations (docs/format.md, 6.4) as something that can be drawn.
/// A judge is any program that writes `flatdt-check 1` objects: its words are trusted for pictures alone, and
/// every value may be wrong, missing or meant for other files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::ref {

/// A condition that fails, with the keys and values of its witness as they were written.
struct FailedCondition {
  std::string name;
  std::vector<std::pair<std::string, std::string>> witness;
};

struct Verdict {
  std::string word;  // VERIFIED, REFUTED, MALFORMED or UNKNOWN
  std::vector<FailedCondition> failed;
};

/// A figure of a witness, in instance coordinates: one corner is a point, two an edge, d+1 a cell.
struct Mark {
  enum class Kind { cell, other_cell, face, other_face, point };
  Kind kind;
  std::vector<Vector> corners;
};

/// A disk or ball of the metric.
struct Ball {
  Vector centre;
  Rational radius_squared;
};

/// What a picture shows of a failing condition.
struct Witness {
  std::string condition;  // empty: found by ref itself
  std::string sentence;   // what fails, in words
  std::vector<Mark> marks;
  std::optional<Ball> ball;
  std::vector<std::uint32_t> cells;    // indices in the file: all copies belong to the witness
  std::optional<std::uint32_t> point;  // index of a point all copies of which belong to it
  std::vector<std::string> notes;      // values that make no sense for these files
  [[nodiscard]] bool has_figure() const { return !marks.empty() || !cells.empty() || point.has_value(); }
};

/// Reads the figures from the witness: `cell-points`, `apex`, `other-apex`, `facet`, `facet-vertices`,
/// `edge`, `other-edge`, `face`, `other-face`, `vertex`, `corners`, `cell`, `other-cell`, `cells`, `point`,
/// `number`. Every other key is ignored; a value that cannot be read, or an index out of range, becomes a
/// note. No errors. Complexity: linear in the text, and in the cells for `number`.
Witness witness_of(const FailedCondition& failed, const Instance& instance,
                   const Triangulation& triangulation);

/// The witness of the condition `name`. If `name` is empty: of the first failing condition that has marks,
/// else of the first that names cells or a point, else of the first. Nothing if no condition fails. Errors:
/// InvalidInput if `name` does not fail.
std::optional<Witness> chosen_witness(const Verdict& verdict, const std::string& name,
                                      const Instance& instance, const Triangulation& triangulation);

/// The ball through the corners of a cell; nothing if it has volume 0.
std::optional<Ball> circumscribed_ball(const Matrix& gram, const std::vector<Vector>& corners);

}  // namespace flatdt::ref
