// The program flatdt-check, apart from main(): callable by tests.
#pragma once

namespace flatdt::checker {

/// Runs the program once and returns its exit code; never throws. Makes GMP end the process where memory runs
/// out.
int run_command_line(int argc, const char* const* argv);

}  // namespace flatdt::checker
