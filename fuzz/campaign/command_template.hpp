/// The command line of an implementation, with places for the two files.
#pragma once

#include <string>
#include <vector>

namespace flatdt::campaign {

/// Splits at blanks; '...' and "..." keep blanks, a backslash outside '...' keeps the next character. Nothing
/// else has a meaning: no variables, no pipes; whoever wants them writes  sh -c '...'. Errors:
/// std::invalid_argument for an empty command or a quote that is not closed.
[[nodiscard]] std::vector<std::string> split_command(const std::string& text);

/// Is {instance} or {output} (without braces in `place`) in some word?
[[nodiscard]] bool has_place(const std::vector<std::string>& words, const std::string& place);

/// The words with {instance} and {output} replaced, wherever they stand.
[[nodiscard]] std::vector<std::string> filled(std::vector<std::string> words, const std::string& instance,
                                              const std::string& output);

/// The words as a line for sh.
[[nodiscard]] std::string shell_line(const std::vector<std::string>& words);
/// The same with the places {instance} and {output} replaced by what sh shall read there as it stands.
[[nodiscard]] std::string shell_line(const std::vector<std::string>& words, const std::string& instance,
                                     const std::string& output);

}  // namespace flatdt::campaign
