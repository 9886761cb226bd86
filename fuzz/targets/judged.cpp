#include "judged.hpp"

#include <sstream>

#include "../engine/expect.hpp"
#include "flatdt/checker/errors.hpp"

namespace flatdt::fuzz {

std::optional<checker::Instance> read_instance(const std::string& text) {
  try {
    std::istringstream in(text);
    return checker::parse_instance(in, "instance");
  } catch (const checker::MalformedInput&) {
    return std::nullopt;
  }
}

std::optional<checker::Triangulation> read_triangulation(const std::string& text,
                                                         const checker::Instance& instance) {
  try {
    std::istringstream in(text);
    return checker::parse_triangulation(in, "triangulation", instance);
  } catch (const checker::MalformedInput&) {
    return std::nullopt;
  }
}

std::optional<checker::Verdict> judge(const checker::Instance& instance,
                                      const checker::Triangulation& triangulation) {
  checker::Verdict verdict = checker::check(instance, triangulation);
  if (verdict.outcome != checker::Outcome::unknown) return verdict;
  expect(verdict.reason.rfind("limit of the checker", 0) == 0, "no verdict is unknown: " + verdict.reason);
  return std::nullopt;
}

}  // namespace flatdt::fuzz
