/// The naive checker: the conditions of FORMAT.md and the definitions of the paper, word for word, for small
/// inputs. Invariants: exact; shares nothing with ref or checker but the public data types that carry input
/// and statuses. Source:     FORMAT.md, "What the conditions mean"; Definitions 1 to 4 of Caroli and
/// Teillaud.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "flatdt/checker/input.hpp"
#include "flatdt/checker/verdict.hpp"

namespace flatdt::naive {

/// What the definitions ask of the H-periodic family HK of lifted cells, each decided on its own.
struct Definitions {
  bool tiling = false;    ///< HK covers E^d, and any two of its simplices meet in a common face or not at all
  bool vertices = false;  ///< the vertices of HK are exactly the points of GP
  bool delaunay = false;  ///< no point of GP is strictly inside the circumscribed ball of a cell
  bool complex =
      false;  ///< a simplicial complex in E^d/H: Definition 3, and Definition 1 (ii) for the images

  /// Definition 4: a Delaunay triangulation of E^d/H.
  [[nodiscard]] bool all() const { return tiling && vertices && delaunay && complex; }
};

struct Report {
  std::array<checker::Status, checker::kConditionCount> status{};  ///< by checker::ConditionName
  checker::Outcome outcome = checker::Outcome::unknown;            ///< verified, refuted or malformed
  /// Absent if the group is inadmissible, subgroup.member fails, or they were not asked for.
  std::optional<Definitions> definitions;
  /// Theorems of docs/soundness.md that the computed facts contradict. Never anything but empty, unless a
  /// theorem, a condition or this program is wrong.
  std::vector<std::string> contradictions;

  [[nodiscard]] checker::Status operator[](checker::ConditionName name) const {
    return status[static_cast<std::size_t>(name)];
  }
};

/// `definitions` is the dear part: exact intersections of all pairs of cells that come near one another.
enum class Depth { conditions, definitions };

/// Judges a triangulation.
/// Requires: both came from the parsers of checker, the triangulation with this instance.
/// Cost:     quadratic in the number of cells; meant for at most a few hundred.
[[nodiscard]] Report naive_check(const checker::Instance& instance,
                                 const checker::Triangulation& triangulation,
                                 Depth depth = Depth::definitions);

/// Where the two checkers disagree, one line each, contradictions included; empty if nowhere.
/// `skipped` for the size limit of topology.homology does not count (it is above what this program can do).
[[nodiscard]] std::string disagreement(const Report& naive, const checker::Verdict& verdict);

}  // namespace flatdt::naive
