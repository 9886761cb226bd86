/// Numbers of the command line: what is no number of the range is refused, never rounded, wrapped or taken
/// for "no limit".
#pragma once

#include <cstdint>
#include <string>

namespace flatdt::campaign {

/// [0-9]+ in [least, most]. `what` names it in errors. Errors: UsageError.
[[nodiscard]] std::uint64_t whole_number(const std::string& text, const std::string& what,
                                         std::uint64_t least, std::uint64_t most);

/// [0-9]+ or [0-9]+.[0-9]+ in [0, most]. Errors: UsageError.
[[nodiscard]] double amount(const std::string& text, const std::string& what, double most);

/// An amount with one of the units s (or none), m and h, in seconds; at most a year. Errors: UsageError.
[[nodiscard]] double parse_duration(const std::string& text);

}  // namespace flatdt::campaign
