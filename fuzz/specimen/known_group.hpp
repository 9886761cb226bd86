/// Analyses of groups that were met before: an analysis takes longer than the triangulation of a few points,
/// and most moves leave the group as it is. The target `group`, whose subject the analysis is, does without.
#pragma once

#include <memory>

#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::fuzz {

/// What ref::analyse says of the instance; kept for the last groups that were admissible. Errors: as there.
[[nodiscard]] std::shared_ptr<const ref::GroupAnalysis> analysed(const ref::Instance& instance);

}  // namespace flatdt::fuzz
