/// Any triangulation of any instance: the checker never contradicts itself, and reads the same from a file as
/// from another that means the same.
#include <algorithm>

#include "../engine/expect.hpp"
#include "../engine/target.hpp"
#include "../specimen/structured_target.hpp"
#include "judged.hpp"

namespace flatdt::fuzz {

const Shape kShape = {.triangulation = true};

namespace {

/// The same cells in another order, each with its vertices in another order.
checker::Triangulation reordered(checker::Triangulation triangulation) {
  const auto corners = static_cast<std::ptrdiff_t>(triangulation.dimension) + 1;
  std::reverse(triangulation.cells.begin(), triangulation.cells.end());
  for (checker::FileCell& cell : triangulation.cells)
    std::rotate(cell.begin(), cell.begin() + 1, cell.begin() + corners);
  return triangulation;
}

}  // namespace
}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatdt::fuzz;
  const Texts texts = texts_of(decode({data, size}, kShape));
  const auto instance = read_instance(texts.instance);
  if (!instance) return 0;  // the metric is not positive definite
  const auto triangulation = read_triangulation(texts.triangulation, *instance);
  expect(triangulation.has_value(), "what ref writes is well formed");
  const auto verdict = judge(*instance, *triangulation);
  if (!verdict) return 0;
  const auto again = judge(*instance, reordered(*triangulation));
  expect(again.has_value() && again->outcome == verdict->outcome,
         "the order in the file does not change the verdict");
  for (std::size_t k = 0; k < flatdt::checker::kConditionCount; ++k)
    expect(again->conditions[k].status == verdict->conditions[k].status,
           "the order in the file does not change a condition: " +
               std::string(to_string(static_cast<flatdt::checker::ConditionName>(k))));
  return 0;
}
