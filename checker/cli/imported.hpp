// flatdt-check --from FORMAT FILE: a file of another program, which is instance and triangulation in one.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "../importers/cgal_stream.hpp"

namespace flatdt::checker {

/// The formats that import_file() knows.
[[nodiscard]] std::vector<std::string> import_formats();

/// Reads a file of a format. Errors: MalformedInput, and whatever reading raises. Requires: the format is one
/// of import_formats().
[[nodiscard]] Imported import_file(std::istream& in, const std::string& file, const std::string& format);

}  // namespace flatdt::checker
