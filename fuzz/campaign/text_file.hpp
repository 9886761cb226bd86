/// Whole files as strings.
#pragma once

#include <cstdint>
#include <string>

namespace flatdt::campaign {

/// The whole file; empty if it does not exist. Errors: std::runtime_error if it cannot be read.
[[nodiscard]] std::string read_text(const std::string& path);
/// The last bytes of a file, at most `most`; empty if it cannot be read, or is no file but a link, a folder
/// or a pipe. Never waits.
[[nodiscard]] std::string read_tail(const std::string& path, std::uint64_t most);
/// Errors: std::runtime_error.
void write_text(const std::string& path, const std::string& text);

}  // namespace flatdt::campaign
