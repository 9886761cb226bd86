/// Counts of what was tried and said, one row a kind, and their print.
#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "edit.hpp"

namespace flatdt::edits {

struct Row {
  std::size_t tries = 0;
  std::size_t caught = 0;  ///< refuted, malformed or refused by a parser
  std::size_t verified = 0;
  std::size_t wrong = 0;  ///< not as the kind expects
  std::array<std::size_t, checker::kConditionCount> failed{};
};

/// Adds what was said of one edited pair. Returns why it is wrong; empty if it is not.
std::string record(Row& row, const Expectation& expectation, const std::optional<checker::Verdict>& verdict);

/// One line a kind: tries, verdicts, the conditions that must fail, and those that did with counts. `rows`
/// belong to kinds().
void print(std::ostream& out, const std::vector<Row>& rows);

}  // namespace flatdt::edits
