/// Which valid triangulations are edited: by ref on all twelve manifolds, the same over smaller subgroups,
/// and files.
#pragma once

#include <string>
#include <vector>

#include "base.hpp"

namespace flatdt::edits {

struct Recipe {
  enum class Form {
    as_written,      ///< by ref: of the manifold, or of the cover that ref chose
    small_cover,     ///< over a small subgroup instead (respace.hpp)
    small_manifold,  ///< the small covering space as a manifold of its own
  };
  std::string manifold;
  std::string family;
  long points;
  std::string metric;
  std::uint64_t seed;
  Form form;
};

/// The recipes of one round; quick: those of little cost.
[[nodiscard]] std::vector<Recipe> recipes(bool quick, std::size_t round, std::uint64_t seed);

/// Nothing if no small subgroup was found for the form, or if what ref wrote has more than 1,600 cells.
/// Errors: those of ref.
[[nodiscard]] std::optional<Base> make_base(const Recipe& recipe);

/// The valid pairs of a folder, by name, of at most `most_cells` cells.
/// Errors: those of ref's parsers.
[[nodiscard]] std::vector<Base> bases_of_folder(const std::string& folder, std::size_t most_cells);

}  // namespace flatdt::edits
