/// Which witnesses a picture shows, and what it says about them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flatdt/ref/refutation.hpp"
#include "picture_group.hpp"

namespace flatdt::ref::picture {

struct WitnessChoice {
  bool violation = false;  // requires dimension 2
  bool two_cycle = false;
  const std::optional<Verdict>& verdict;
  const std::string& condition;
};

/// What is to be shown, with a note on each, and on what was looked for and not found. Errors: InvalidInput
/// if the condition asked for does not fail.
std::vector<Witness> witnesses_of(const Instance& instance, const Triangulation& triangulation,
                                  const WitnessChoice& choice, const PictureGroup& full,
                                  const ShownGroup& shown, std::vector<std::string>& notes);

/// The first cell whose circumdisk has a point of the instance strictly inside, with the deepest such point.
/// Requires: dimension 2.
std::optional<Witness> find_violation(const Instance& instance, const Triangulation& triangulation,
                                      const PictureGroup& group);

/// The first edge in the order of the cells whose ends are one vertex modulo the group, else the first two
/// different edges modulo the group with the same ends; decided exactly. Nothing if there is neither.
std::optional<Witness> find_cycle(const Instance& instance, const Triangulation& triangulation,
                                  const PictureGroup& group);

/// Adds a mark for every other listed cell that has the facet of the first mark of kind `face`, laid on that
/// facet by an element of the group: what is glued where a facet occurs once or three times. At most eight;
/// none if there are more than 5,000 cells. Complexity: O(cells) canonical faces.
void add_cells_at_facet(Witness& witness, const Instance& instance, const Triangulation& triangulation,
                        const PictureGroup& group);

}  // namespace flatdt::ref::picture
