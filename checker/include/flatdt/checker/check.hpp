// The entry point of the checker.
#pragma once

#include "flatdt/checker/input.hpp"
#include "flatdt/checker/verdict.hpp"

namespace flatdt::checker {

/// The stages of exact arithmetic that may be used where they apply, and threads. The verdict, with all
/// witnesses, is the same for every choice; tests force each.
struct Stages {
  bool filter = true;       ///< floating point with certified bounds
  bool fixed_width = true;  ///< machine integers, where all numbers of the input fit
  unsigned jobs = 1;        ///< threads at a time; fewer than 1 are 1, more than kMostJobs are kMostJobs

  static constexpr unsigned kMostJobs = 256;
};

/// Judges whether `triangulation` is a Delaunay triangulation of the points of `instance` in E^d/H.
/// Returns:  the status of every condition with its witness, and the verdict; never throws for an input's
/// fault. A limit
///           of the checker (below), lack of memory or a contradiction makes it unknown, with the reason.
/// Requires: both came from the parsers, the triangulation with this instance.
/// Limits:   20,000 bits for every numerator and common denominator of the group; 200,000 cells and 100
/// critical
///           faces for topology.homology, which is then skipped.
/// Cost:     expected O(n log n) for n cells, in operations on numbers of the size of the input's.
/// Source:   FORMAT.md; docs/soundness.md proves that `verified` is given exactly to the correct ones.
[[nodiscard]] Verdict check(const Instance& instance, const Triangulation& triangulation,
                            const Stages& stages = {});

}  // namespace flatdt::checker
