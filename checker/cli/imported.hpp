// flatdt-check --from FORMAT FILE: a file of another program, which is instance and triangulation in one.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "flatdt/checker/verdict.hpp"

namespace flatdt::checker {

/// The formats that import() knows.
[[nodiscard]] std::vector<std::string> import_formats();

/// Reads a file of a format and judges it; `note` is what the reader of the verdict should know.
/// Errors: MalformedInput, and whatever reading raises. Requires: the format is one of import_formats().
[[nodiscard]] Verdict judge_imported(std::istream& in, const std::string& file, const std::string& format,
                                     std::string& note);

}  // namespace flatdt::checker
