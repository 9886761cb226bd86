/// What an answer is worth.
#pragma once

#include <string>
#include <vector>

#include "capabilities.hpp"
#include "implementation.hpp"

namespace flatdt::campaign {

enum class Worth : std::uint8_t { right, unsupported, wrong };

struct Judgement {
  Worth worth = Worth::right;
  /// One line that two failures share if and only if they fail in the same way: "refuted delaunay.empty",
  /// "malformed", "signal SIGSEGV", "exit status 1", "time limit". Empty unless wrong.
  std::string signature;
  /// The verdict as the JSON object that `flatdt-check --json` prints (claims of edges: of the same shape);
  /// empty if nothing was judged.
  std::string verdict;
  /// For people: the reason of a malformed output, what stood in the standard error.
  std::string reason;
};

/// Judges the answer to an instance with the checker's library; a claim of edges with ref's triangulation.
/// Errors: std::logic_error if the instance itself is refused: a defect of the campaign.
[[nodiscard]] Judgement judge(const std::string& instance, const Answer& answer,
                              const Capabilities& capabilities);

}  // namespace flatdt::campaign
