// The two forms in which a verdict is printed.   Source: FORMAT.md, "Programs".
#pragma once

#include <string>

#include "flatdt/checker/verdict.hpp"

namespace flatdt::checker {

/// Lines "c condition NAME STATUS key=value ..." and last "s VERDICT".
[[nodiscard]] std::string text_report(const Verdict& verdict);
/// One JSON object with the schema "flatdt-check 1", and a line feed.
[[nodiscard]] std::string json_report(const Verdict& verdict);

}  // namespace flatdt::checker
