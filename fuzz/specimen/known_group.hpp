/// Analyses of groups that were met before: an analysis takes longer than the triangulation of a few points,
/// and most moves leave the group as it is. The target `group`, whose subject the analysis is, does without.
#pragma once

#include <memory>

#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/prepared_group.hpp"

namespace flatdt::fuzz {

/// The group of the instance, kept for the last groups that were admissible. Errors: as ref::analyse, and as
/// ref::PreparedGroup.
[[nodiscard]] std::shared_ptr<const ref::PreparedGroup> prepared(const ref::Instance& instance);

}  // namespace flatdt::fuzz
