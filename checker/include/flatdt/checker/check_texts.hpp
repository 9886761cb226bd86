// The checker on two files that are in memory.
#pragma once

#include <string>
#include <string_view>

#include "flatdt/checker/check.hpp"

namespace flatdt::checker {

/// What the texts are called in reasons: "instance:5: a point: ...".
struct TextNames {
  std::string instance = "instance";
  std::string triangulation = "triangulation";
};

/// Parses both texts and judges them, as flatdt-check does with two files.
/// Returns: the verdict. A text that breaks the grammar makes it malformed with the reason, lack of memory
/// unknown;
///          never throws for an input's fault.
/// Errors:  std::bad_alloc where not even a reason can be stored. GMP ends the process where an allocation of
///          its own fails (mp_set_memory_functions can change that).
/// Limits, Cost: as check(); the texts are read where they are.
[[nodiscard]] Verdict check_texts(std::string_view instance, std::string_view triangulation,
                                  const TextNames& names = {});

}  // namespace flatdt::checker
