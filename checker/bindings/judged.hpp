// Judging in a place that owes an answer whatever comes: what parsing and checking throw becomes a verdict.
#pragma once

#include <new>

#include "flatdt/checker/errors.hpp"
#include "flatdt/checker/verdict.hpp"

namespace flatdt::checker {

/// The verdict that `judging` gives; malformed, with the reason, for an input that breaks the grammar,
/// unknown where memory runs out. Errors: whatever else `judging` raises; std::bad_alloc if not even the
/// reason can be stored.
template <class Judging>
[[nodiscard]] Verdict judged(const Judging& judging) {
  Verdict verdict;
  try {
    return judging();
  } catch (const MalformedInput& error) {
    verdict.outcome = Outcome::malformed;
    verdict.reason = error.what();
  } catch (const std::bad_alloc&) {
    verdict.outcome = Outcome::unknown;
    verdict.reason = "out of memory";
  }
  return verdict;
}

}  // namespace flatdt::checker
