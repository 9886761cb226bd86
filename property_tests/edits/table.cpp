#include "table.hpp"

#include <algorithm>
#include <iomanip>

namespace flatdt::edits {

using checker::Outcome;
using checker::Status;

namespace {

std::string names(const Conditions& conditions, const std::string& separator) {
  std::string text;
  for (const checker::ConditionName name : conditions)
    text += (text.empty() ? "" : separator) + std::string(to_string(name));
  return text;
}

std::string demand(const Expectation& expectation) {
  switch (expectation.effect) {
    case Expectation::Effect::keeps:
      return "verified";
    case Expectation::Effect::unreadable:
      return "malformed";
    case Expectation::Effect::breaks:
      break;
  }
  std::string text = names(expectation.fail, " and ");
  if (!expectation.one_of.empty())
    text += (text.empty() ? "" : ", and ") + std::string("one of ") + names(expectation.one_of, ", ");
  return text;
}

std::string counts(const Row& row) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < row.failed.size(); ++i)
    if (row.failed[i] > 0) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return row.failed[a] != row.failed[b] ? row.failed[a] > row.failed[b] : a < b;
  });
  std::string text;
  for (const std::size_t i : order)
    text += (text.empty() ? "" : ", ") + std::string(to_string(static_cast<checker::ConditionName>(i))) +
            " " + std::to_string(row.failed[i]);
  return text;
}

}  // namespace

std::string record(Row& row, const Expectation& expectation, const std::optional<checker::Verdict>& verdict) {
  ++row.tries;
  if (!verdict || verdict->outcome == Outcome::refuted || verdict->outcome == Outcome::malformed)
    ++row.caught;
  if (verdict && verdict->outcome == Outcome::verified) ++row.verified;
  if (verdict)
    for (std::size_t i = 0; i < row.failed.size(); ++i)
      if (verdict->conditions[i].status == Status::fails) ++row.failed[i];
  std::string why = contradiction(expectation, verdict);
  if (!why.empty()) ++row.wrong;
  return why;
}

void print(std::ostream& out, const std::vector<Row>& rows) {
  const auto line = [&](const Expectation::Effect effect, const std::string& title) {
    std::size_t count = 0;
    std::size_t tries = 0;
    std::size_t right = 0;
    out << "\n"
        << title << "\n"
        << std::left << std::setw(60) << "kind" << std::right << std::setw(7) << "tries" << std::setw(8)
        << "caught" << std::setw(10) << "verified"
        << "  must be: / conditions that failed\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Kind& kind = kinds()[i];
      if (kind.expectation.effect != effect) continue;
      const Row& row = rows[i];
      ++count;
      tries += row.tries;
      right += row.tries - row.wrong;
      out << std::left << std::setw(60) << kind.name << std::right << std::setw(7) << row.tries
          << std::setw(8) << row.caught << std::setw(10) << row.verified << "  " << demand(kind.expectation);
      if (effect == Expectation::Effect::breaks) out << " / " << counts(row);
      if (row.wrong > 0) out << "  WRONG " << row.wrong;
      if (row.tries == 0) out << "  NEVER APPLIED";
      out << "\n";
    }
    out << count << " kinds, " << right << " of " << tries << " as they must be\n";
  };
  line(Expectation::Effect::breaks, "Edits that invalidate");
  line(Expectation::Effect::unreadable, "Edits that break the grammar");
  line(Expectation::Effect::keeps, "Edits that keep validity");
}

}  // namespace flatdt::edits
