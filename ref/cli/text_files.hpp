/// Reading inputs (`-` is standard input) and writing results (atomically) for the subcommands.
#pragma once

#include <string>

namespace flatdt::ref::cli {

/// The whole content of a file, or of standard input for "-". Throws InvalidInput if it cannot be read,
/// LimitReached beyond 2^31 bytes.
std::string read_input(const std::string& path);

/// Writes text to a temporary file beside `path` and renames it, or to standard output for "-".
/// Throws InvalidInput if the file cannot be created, LimitReached if writing fails; leaves nothing behind.
void write_output(const std::string& path, const std::string& text);

}  // namespace flatdt::ref::cli
