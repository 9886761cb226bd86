/// Reader and writer of `flatdt-instance 1` files (FORMAT: lexical rules, limits).
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "flatdt/ref/instance.hpp"

namespace flatdt::ref {

/// Parses a whole file. `file_name` is used in messages only.
/// Errors: InvalidInput "file:line: reason". Memory grows with the text, never with a count.
Instance parse_instance(std::string_view text, const std::string& file_name);

/// The canonical text of an instance: reduced rationals; parse_instance(write_instance(x)) equals x.
/// Errors: LimitReached if a reduced rational is longer than a token may be.
std::string write_instance(const Instance& instance);

}  // namespace flatdt::ref
