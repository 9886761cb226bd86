/// What the checker makes of texts, as its program would read them, and of what ref found.
#pragma once

#include <optional>
#include <string>

#include "flatdt/checker/check.hpp"
#include "flatdt/checker/input.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::fuzz {

/// Nothing if it is malformed.
[[nodiscard]] std::optional<checker::Instance> read_instance(const std::string& text);
[[nodiscard]] std::optional<checker::Triangulation> read_triangulation(const std::string& text,
                                                                       const checker::Instance& instance);

/// The triangulation as the checker would read it, were it written and read.
[[nodiscard]] checker::Triangulation for_checker(const ref::Triangulation& triangulation);

/// The verdict; expects that it is not unknown but for a limit of the checker. Nothing at a limit.
[[nodiscard]] std::optional<checker::Verdict> judge(const checker::Instance& instance,
                                                    const checker::Triangulation& triangulation);

}  // namespace flatdt::fuzz
