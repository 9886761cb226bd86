/// What is known of one case.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flatdt::campaign {

/// A line of results.jsonl.
struct Result {
  std::uint64_t number = 0;
  std::string manifold;
  std::string family;
  std::size_t points = 0;
  std::string outcome;  // "right", "unsupported", "wrong"
  double seconds = 0;
  // Of wrong ones:
  std::string signature;
  std::string reason;
  /// Of those that were minimised: the form of the shrunk case ("torus, another metric"), its number of
  /// points, and its bundle, a folder relative to that of the campaign.
  std::string form;
  std::size_t shrunk_points = 0;
  std::string bundle;
  bool finished = false;  // nothing simpler fails in the same way
};

/// Failures that look like one defect: the same signature and, where minimised, the same form. Shrinking ends
/// in local minima, so that the number of points of shrunk cases of one defect varies and is no part of the
/// form. The one with the fewest points stands first.
struct Group {
  std::string signature;
  std::string form;  // empty: those that were not minimised
  std::vector<Result> failures;
};

/// For people: the form with the number of points of the smallest shrunk case.
[[nodiscard]] std::string title(const Group& group);

/// One group for each signature and form, in the order of their first failures by case number. Failures that
/// were not minimised are counted with the only form of their signature or, where it has several, with that
/// of their manifold; else they are a group of their own.
[[nodiscard]] std::vector<Group> grouped(std::vector<Result> failures);

}  // namespace flatdt::campaign
