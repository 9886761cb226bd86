#include "edit.hpp"

#include <algorithm>

#include "flatdt/ref/errors.hpp"

namespace flatdt::edits {

using checker::ConditionName;
using checker::Outcome;
using checker::Status;

Expectation keeps() {
  return {};
}

Expectation breaks(Conditions fail, Conditions one_of, Conditions hold) {
  return {Expectation::Effect::breaks, std::move(fail), std::move(one_of), std::move(hold)};
}

Expectation unreadable() {
  return {Expectation::Effect::unreadable, {}, {}, {}};
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = [] {
    std::vector<Kind> list;
    for (const auto& group : {cell_kinds(), shape_kinds(), label_kinds(), flip_kinds(), cover_kinds(),
                              point_kinds(), group_kinds(), rewriting_kinds(), coordinate_kinds()})
      list.insert(list.end(), group.begin(), group.end());
    return list;
  }();
  return all;
}

std::optional<Files> edit(const Kind& kind, const Base& base, std::uint64_t seed) {
  Random random(seed, std::string(kind.name) + "/" + base.label());
  try {
    return kind.apply(base, random);
  } catch (const ref::LimitReached&) {
    return std::nullopt;  // a number of the result is longer than a token may be
  }
}

std::string contradiction(const Expectation& expectation, const std::optional<checker::Verdict>& verdict) {
  using Effect = Expectation::Effect;
  if (!verdict) return expectation.effect == Effect::unreadable ? "" : "a parser refused a file";
  const auto status = [&](ConditionName name) { return (*verdict)[name].status; };
  const std::string outcome(to_string(verdict->outcome));
  if (expectation.effect == Effect::unreadable) return "parsed, then " + outcome;
  if (expectation.effect == Effect::keeps)
    return verdict->outcome == Outcome::verified ? "" : outcome + " " + verdict->reason;

  const auto fails = [&](ConditionName name) { return status(name) == Status::fails; };
  const bool of_group = std::any_of(expectation.fail.begin(), expectation.fail.end(),
                                    [](ConditionName name) { return name <= ConditionName::group_name; });
  if (verdict->outcome != (of_group ? Outcome::malformed : Outcome::refuted))
    return outcome + " " + verdict->reason;
  for (const ConditionName name : expectation.fail)
    if (!fails(name)) return std::string(to_string(name)) + " " + std::string(to_string(status(name)));
  for (const ConditionName name : expectation.hold)
    if (status(name) != Status::holds)
      return std::string(to_string(name)) + " " + std::string(to_string(status(name)));
  if (!expectation.one_of.empty() &&
      std::none_of(expectation.one_of.begin(), expectation.one_of.end(), fails))
    return "none of the conditions fails of which one must";
  return "";
}

}  // namespace flatdt::edits
