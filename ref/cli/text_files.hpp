/// Reading inputs (`-` is standard input) and writing results (atomically) for the subcommands.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace flatdt::ref::cli {

/// The whole content of a file, or of standard input for "-". Throws InvalidInput if it cannot be read,
/// LimitReached beyond 2^31 bytes.
std::string read_input(const std::string& path);

/// Writes text to a temporary file beside `path` and renames it, or to standard output for "-".
/// Throws InvalidInput if the file cannot be created, LimitReached if writing fails; leaves nothing behind.
void write_output(const std::string& path, const std::string& text);

/// Gives a text to a function, piece by piece.
using Writer = std::function<void(const std::function<void(std::string_view)>&)>;

/// A text and where it goes.
struct Output {
  std::string path;
  Writer write;
  static Output of_text(std::string path, std::string text);
};
/// The same for several outputs, all or none: files are renamed when all have been written.
/// Throws InvalidInput also if two of them go to the same place.
void write_outputs(const std::vector<Output>& outputs);

}  // namespace flatdt::ref::cli
