/// Values of witnesses (docs/format.md, 6.4): "(1/2,3);(0,1)" are points, "[-1,0|0;0,1|1/2]*4" is an element
/// applied to a point of the instance.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "flatdt/ref/instance.hpp"

namespace flatdt::ref {

/// Points in parentheses, separated by semicolons, each of `dimension` coordinates. Nothing if the text is
/// anything else.
std::optional<std::vector<Vector>> read_points(std::string_view text, int dimension);
/// Elements applied to points of the instance, separated by semicolons. Nothing if the text is anything else
/// or an index is out of range.
std::optional<std::vector<Vector>> read_lifts(std::string_view text, const Instance& instance);
/// Decimal indices below `bound`, separated by commas. Nothing if the text is anything else.
std::optional<std::vector<std::uint32_t>> read_indices(std::string_view text, std::size_t bound);

}  // namespace flatdt::ref
