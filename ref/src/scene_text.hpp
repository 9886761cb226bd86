/// Numbers and strings of the files that scenes are written to.
#pragma once

#include <string>
#include <string_view>

#include "flatdt/ref/scene.hpp"

namespace flatdt::ref {

/// The value with that many significant digits, without regard to the locale. Requires: finite.
std::string decimal_text(double value, int digits);
/// A JSON string, quotes included, of ASCII that is also harmless inside an HTML script element: '<', '>',
/// '&', control characters and bytes beyond ASCII are escaped.
std::string json_string(std::string_view plain);

}  // namespace flatdt::ref
