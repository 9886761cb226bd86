/// The naive checker, flatdt::checker and the records agree on every condition of the files of corpora.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>

#include "fixture.hpp"
#include "flatdt/checker/check.hpp"
#include "flatdt/checker/errors.hpp"
#include "naive_checker/naive_check.hpp"

namespace flatdt::naive {
namespace {

using checker::Status;
using oracle_tests::read_instance;
using oracle_tests::read_triangulation;
using oracle_tests::stems;
using oracle_tests::text_of;
using oracle_tests::with;

/// Pairs of cells are intersected: beyond this the definitions take seconds.
constexpr std::size_t kMaxCellsOfDefinitions = FLATDT_DEFINITION_CELLS;
/// The conditions alone are nearly linear.
constexpr std::size_t kMaxCellsOfConditions = FLATDT_CONDITION_CELLS;

/// "verdict", "exit" and every condition of a record: key -> word.
std::map<std::string, std::string> record_of(const std::string& text) {
  std::map<std::string, std::string> record;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string key;
    std::string value;
    if (words >> key >> value) record[key] = value;
  }
  return record;
}

std::string against_record(const Report& report, const std::map<std::string, std::string>& record) {
  std::string text;
  for (std::size_t k = 0; k < checker::kConditionCount; ++k) {
    const auto name = static_cast<checker::ConditionName>(k);
    if (record.at(std::string(to_string(name))) != to_string(report[name]))
      text += std::string(to_string(name)) + ": naive " + std::string(to_string(report[name])) + "\n";
  }
  if (record.at("verdict") != to_string(report.outcome)) text += "verdict\n";
  return text;
}

TEST(NaiveChecker, AgreesOnTheCorpora) {
  std::size_t conditions = 0;
  std::size_t definitions = 0;
  std::size_t malformed = 0;
  std::size_t too_large = 0;
  std::map<std::string, int> failing;
  std::vector<std::filesystem::path> files = stems(FLATDT_CORPORA "/valid", ".triangulation");
  for (const auto& stem : stems(FLATDT_CORPORA "/invalid", ".triangulation")) files.push_back(stem);
  for (const auto& stem : stems(FLATDT_CORPORA "/adversarial", ".triangulation")) files.push_back(stem);
  for (const auto& stem : files) {
    SCOPED_TRACE(stem);
    try {
      const checker::Instance instance = read_instance(text_of(with(stem, ".instance")));
      const checker::Triangulation triangulation =
          read_triangulation(text_of(with(stem, ".triangulation")), instance);
      if (triangulation.cells.size() > kMaxCellsOfConditions) {
        ++too_large;
        continue;
      }
      const bool is_small = triangulation.cells.size() <= kMaxCellsOfDefinitions;
      const Report report =
          naive_check(instance, triangulation, is_small ? Depth::definitions : Depth::conditions);
      EXPECT_EQ(disagreement(report, check(instance, triangulation)), "");
      if (std::filesystem::exists(with(stem, ".expected"))) {
        EXPECT_EQ(against_record(report, record_of(text_of(with(stem, ".expected")))), "");
      }
      ++conditions;
      definitions += report.definitions ? 1 : 0;
      for (std::size_t k = 0; k < checker::kConditionCount; ++k)
        if (report.status[k] == Status::fails)
          ++failing[std::string(to_string(static_cast<checker::ConditionName>(k)))];
    } catch (const checker::MalformedInput&) {
      ++malformed;  // refused by the parser, which all share
      EXPECT_EQ(record_of(text_of(with(stem, ".expected"))).at("verdict"), "MALFORMED");
    }
  }
  std::cout << conditions << " files compared on every condition, " << definitions
            << " of them with the definitions (at most " << kMaxCellsOfDefinitions << " cells); " << too_large
            << " too large (more than " << kMaxCellsOfConditions << " cells); " << malformed
            << " refused by the parser\n";
  for (std::size_t k = 0; k < checker::kConditionCount; ++k) {
    const std::string name(to_string(static_cast<checker::ConditionName>(k)));
    std::cout << "  " << name << " fails in " << failing[name] << "\n";
    EXPECT_GT(failing[name], 0) << name;
  }
}

}  // namespace
}  // namespace flatdt::naive
