/// Any triangulation of any instance: the checker never contradicts itself, and reads the same from a file as
/// from another that means the same.
#include <algorithm>

#include "../engine/expect.hpp"
#include "../engine/laws.hpp"
#include "../engine/target.hpp"
#include "../specimen/structured_target.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "judged.hpp"
#include "naive_checker/naive_check.hpp"

namespace flatdt::fuzz {

const Shape kShape = {.triangulation = true};

namespace {

/// The laws that are not asked of every input.
enum Law : std::uint64_t { kText = 1, kOrder, kNaive };

/// Cells up to which the naive checker is asked for the conditions, and up to which it is asked always;
/// beyond it the seldomer, the more cells there are.
constexpr std::size_t kMaxCellsForConditions = 60;
constexpr std::size_t kCellsForConditions = 12;
/// The definitions are decided by intersecting all pairs of cells that come near one another: that takes less
/// than a second for few small cells in the plane only.
constexpr std::size_t kMaxCellsForDefinitions = 12;

bool can_decide_definitions(const Specimen& specimen) {
  const auto is_small = [](const CodedElement& g) {
    return !g.listed && std::all_of(g.shift.begin(), g.shift.end(), [](int s) { return -2 <= s && s <= 2; });
  };
  return specimen.dimension() == 2 && specimen.named() != nullptr &&
         metric_of(specimen) == specimen.named()->entry->canonical_gram &&
         specimen.cells.size() <= kMaxCellsForDefinitions &&
         std::all_of(specimen.elements.begin(), specimen.elements.end(), is_small) &&
         std::all_of(specimen.points.begin(), specimen.points.end(), [](const ref::Vector& x) {
           return abs(x[0]) <= ref::Rational(2) && abs(x[1]) <= ref::Rational(2);
         });
}

void compare_with_definitions(const Specimen& specimen, const checker::Instance& instance,
                              const checker::Triangulation& triangulation, const checker::Verdict& verdict) {
  if (triangulation.cells.size() > kMaxCellsForConditions) return;
  const auto depth = can_decide_definitions(specimen) ? naive::Depth::definitions : naive::Depth::conditions;
  const std::string found = naive::disagreement(naive::naive_check(instance, triangulation, depth), verdict);
  expect(found.empty(), "the checker agrees with the naive checker: " + found);
}

/// The same cells in another order, each with its vertices in another order.
checker::Triangulation reordered(checker::Triangulation triangulation) {
  const auto corners = static_cast<std::ptrdiff_t>(triangulation.dimension) + 1;
  std::reverse(triangulation.cells.begin(), triangulation.cells.end());
  for (checker::FileCell& cell : triangulation.cells)
    std::rotate(cell.begin(), cell.begin() + 1, cell.begin() + corners);
  return triangulation;
}

void expect_same_in_other_order(const checker::Instance& instance,
                                const checker::Triangulation& triangulation,
                                const checker::Verdict& verdict) {
  const auto again = judge(instance, reordered(triangulation));
  expect(again.has_value() && again->outcome == verdict.outcome,
         "the order in the file does not change the verdict");
  for (std::size_t k = 0; k < checker::kConditionCount; ++k)
    if (again->conditions[k].status != verdict.conditions[k].status)
      expect(false, "the order in the file does not change a condition: " +
                        std::string(to_string(static_cast<checker::ConditionName>(k))));
}

}  // namespace
}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatdt::fuzz;
  const std::span<const std::uint8_t> bytes{data, size};
  const Specimen specimen = decode(bytes, kShape);
  const auto instance = read_instance(flatdt::ref::write_instance(instance_of(specimen)));
  if (!instance) return 0;  // the metric is not positive definite
  auto triangulation = for_checker(triangulation_of(specimen));
  if (is_asked(bytes, kText, 4)) {
    auto read = read_triangulation(texts_of(specimen).triangulation, *instance);
    expect(read.has_value(), "what ref writes is well formed");
    triangulation = *std::move(read);
  }
  const auto verdict = judge(*instance, triangulation);
  if (!verdict) return 0;
  if (is_asked(bytes, kOrder, 4)) expect_same_in_other_order(*instance, triangulation, *verdict);
  const std::size_t dearness = 1 + triangulation.cells.size() / kCellsForConditions;
  if (is_asked(bytes, kNaive, dearness * dearness))
    compare_with_definitions(specimen, *instance, triangulation, *verdict);
  return 0;
}
