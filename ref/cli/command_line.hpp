/// The command line of `flatdt`, apart from main(): callable by tests.
#pragma once

namespace flatdt::ref::cli {

/// Runs the program once.
/// Returns the exit code: 0 done, 2 bad input or wrong usage, 3 internal error or a resource limit; reasons
/// are on standard error. Never throws.
int run_command_line(int argc, const char* const* argv);

}  // namespace flatdt::ref::cli
