/// Reader of the JSON objects that `flatdt-check --json` prints (docs/format.md, 6.4).
#pragma once

#include <string>

#include "flatdt/ref/refutation.hpp"

namespace flatdt::ref::cli {

inline constexpr std::size_t kMaxVerdictBytes = std::size_t{1} << 24;
/// A judge has some twenty; the work for each may be linear in the cells.
inline constexpr std::size_t kMaxConditions = 100;

/// The verdict word and the conditions that fail. Keys that are not known are ignored.
/// Errors: InvalidInput "file: reason" if the text is not one JSON object with the schema "flatdt-check 1",
/// or a word or a condition's name is not of letters, digits, '.', '-' and '_'; LimitReached above
/// kMaxVerdictBytes.
Verdict parse_verdict(const std::string& text, const std::string& file_name);

}  // namespace flatdt::ref::cli
