/// Valid triangulations made for kinds of edit that hardly ever apply to others: spaces with so few points
/// that all are joined, and spheres with as many points as a flip needs.
#pragma once

#include <string_view>
#include <vector>

#include "base.hpp"

namespace flatdt::edits {

struct Crafted {
  Base base;
  std::vector<std::string_view> made_for;  ///< names of kinds that apply to it; --quick tries these only
};

/// All of them, of at most 400 cells each.
/// Errors: std::logic_error if one is not simplicial any more, which a change of ref's tie-break may cause.
[[nodiscard]] std::vector<Crafted> crafted_bases();

}  // namespace flatdt::edits
