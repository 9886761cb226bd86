/// Other texts for the same file: docs/format.md, section 1.
#pragma once

#include <cstdint>
#include <string>

namespace flatdt::property_tests {

/// The same tokens with other white space and comments, and numbers of metric, generators, points, subgroup
/// and elements written in other ways: unreduced, as decimals, in hexadecimal, with a plus sign, in capitals.
std::string respell(const std::string& text, std::uint64_t seed);

}  // namespace flatdt::property_tests
