/// A campaign: draws cases, runs the implementation on them, judges, shrinks, records.
#pragma once

#include <atomic>

#include "ledger.hpp"
#include "options.hpp"

namespace flatdt::campaign {

/// Runs until the cases are done, the time is over, or `stop` is set. The folder options.out exists.
/// Errors: std::runtime_error, std::logic_error for failures of the campaign itself (never for those of the
/// implementation).
void run_campaign(const Options& options, Ledger& ledger, const std::atomic<bool>& stop);

/// The form of a shrunk case: what two shrunk cases of one defect have in common.
[[nodiscard]] std::string form_of(const testing::Specimen& specimen);

}  // namespace flatdt::campaign
