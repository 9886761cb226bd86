/// The naive checker, flatdt::checker and the records agree on every condition of the files of corpora.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "fixture.hpp"
#include "flatdt/checker/check.hpp"
#include "flatdt/checker/errors.hpp"
#include "naive_checker/naive_check.hpp"
#include "oracle/compare.hpp"
#include "oracle/voronoi.hpp"

namespace flatdt::naive {
namespace {

using checker::Status;
using oracle_tests::read_instance;
using oracle_tests::read_triangulation;
using oracle_tests::stems;
using oracle_tests::text_of;
using oracle_tests::with;

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

/// FLATDT_CONDITION_CELLS: exact rational arithmetic takes milliseconds a cell in space, so CI leaves out the
/// largest files. FLATDT_DEFINITION_CELLS: pairs of cells are intersected, so the bound is lower.
TEST(NaiveChecker, AgreesOnTheCorpora) {
  const std::size_t max_cells_of_conditions = oracle_tests::setting("FLATDT_CONDITION_CELLS", 275);
  const std::size_t max_cells_of_definitions = oracle_tests::setting("FLATDT_DEFINITION_CELLS", 100);
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
      if (triangulation.cells.size() > max_cells_of_conditions) {
        ++too_large;
        continue;
      }
      const bool is_small = triangulation.cells.size() <= max_cells_of_definitions;
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
            << " of them with the definitions (at most " << max_cells_of_definitions << " cells); "
            << too_large << " too large (more than " << max_cells_of_conditions << " cells); " << malformed
            << " refused by the parser\n";
  for (std::size_t k = 0; k < checker::kConditionCount; ++k) {
    const std::string name(to_string(static_cast<checker::ConditionName>(k)));
    std::cout << "  " << name << " fails in " << failing[name] << "\n";
    EXPECT_GT(failing[name], 0) << name;
  }
}

/// The oracle's comparison accepts the triangulations that are right and refuses those that are not Delaunay.
TEST(Compare, AgreesWithTheCorpora) {
  const std::size_t max_cells = oracle_tests::setting("FLATDT_CONDITION_CELLS", 275);
  std::size_t right = 0;
  std::size_t wrong = 0;
  for (const std::string folder : {"/valid", "/invalid/delaunay.empty"}) {
    for (const auto& stem : stems(FLATDT_CORPORA + folder, ".triangulation")) {
      const checker::Instance instance = read_instance(text_of(with(stem, ".instance")));
      const checker::Triangulation triangulation =
          read_triangulation(text_of(with(stem, ".triangulation")), instance);
      if (triangulation.cells.size() > max_cells) continue;
      const std::string found =
          oracle::difference(instance, oracle::delaunay_tessellation(instance), triangulation);
      EXPECT_EQ(found.empty(), folder == "/valid") << stem << ": " << found;
      ++(folder == "/valid" ? right : wrong);
    }
  }
  std::cout << right << " triangulations equal to the tessellation, " << wrong << " refused\n";
  EXPECT_GT(right, 0U);
  EXPECT_GT(wrong, 0U);
}

}  // namespace
}  // namespace flatdt::naive
