// What the checker answers: a status and a witness for every condition, and the verdict they make.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flatdt::checker {

/// The conditions, in the order of evaluation. Source: FORMAT.md, "What the conditions mean".
enum class ConditionName {
  group_crystallographic,
  group_torsion_free,
  group_name,
  subgroup_member,
  vertices_complete,
  cells_nondegenerate,
  facets_paired,
  facets_opposite,
  volume_exact,
  delaunay_empty,
  simplices_injective,
  skeleton_no_loop,
  skeleton_no_2_cycle,
  complex_intersection,
  links_spheres,
  topology_connected,
  topology_euler,
  topology_orientable,
  topology_homology,
};
inline constexpr std::size_t kConditionCount = 19;

enum class Status { holds, fails, skipped };
enum class Outcome { verified, refuted, malformed, unknown };

/// Named exact values from which a condition's status can be recomputed by hand; values hold no white space.
using Witness = std::vector<std::pair<std::string, std::string>>;

struct Condition {
  Status status = Status::skipped;
  Witness witness;
};

/// The whole answer. `reason` says why the outcome is malformed or unknown, and is empty otherwise.
struct Verdict {
  Outcome outcome = Outcome::unknown;
  std::array<Condition, kConditionCount> conditions;
  std::string reason;

  [[nodiscard]] const Condition& operator[](ConditionName name) const {
    return conditions[static_cast<std::size_t>(name)];
  }
  [[nodiscard]] Condition& operator[](ConditionName name) {
    return conditions[static_cast<std::size_t>(name)];
  }
};

/// The words of FORMAT.md: "group.crystallographic", "holds", "VERIFIED".
[[nodiscard]] std::string_view to_string(ConditionName name);
[[nodiscard]] std::string_view to_string(Status status);
[[nodiscard]] std::string_view to_string(Outcome outcome);

/// Sets outcome (and reason) from the statuses alone: the rules of FORMAT.md, "Programs", and the conditions
/// that must agree. A disagreement makes the outcome unknown whatever else failed. `claimed`: a name was
/// claimed. Source: docs/soundness.md, section 6.
void conclude(Verdict& verdict, bool claimed);

}  // namespace flatdt::checker
