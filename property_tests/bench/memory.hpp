/// Peak memory of this process, for programs that do one thing.
#pragma once

#include <string>

#include "experiment.hpp"

namespace flatdt::bench {

/// Does one part of the memory experiment in this process and prints one line of JSON:
///   {"experiment":"memory","part":..,"items":..,"peak_kb":..,"input_kb":..}
/// peak_kb: VmHWM at the end; input_kb: the resident memory after the points were made.
/// Parts: nothing (an empty process), flatdt, cgal. Errors: std::invalid_argument for another part.
void run_memory(const std::string& part, const Settings& settings);

}  // namespace flatdt::bench
