/// Instances: what ref writes is VERIFIED, and does not depend on its internal choices: both engines, every
/// order, with and without the filter.
#include "flatdt/ref/triangulate.hpp"
#include "../engine/expect.hpp"
#include "../engine/target.hpp"
#include "../specimen/structured_target.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "judged.hpp"

namespace flatdt::fuzz {

const Shape kShape = {};

namespace {

/// Copies of points up to which the covering engine is asked as well: each costs an insertion.
constexpr long kMaxCopiesInPlane = 200;
constexpr long kMaxCopiesInSpace = 80;

std::string triangulated(const ref::Instance& instance, const ref::GroupAnalysis& analysis,
                         const ref::TriangulationOptions& options) {
  const ref::TriangulationResult result = ref::triangulate(instance, analysis, options);
  return ref::write_triangulation(result.triangulation, ref::describe(result));
}

void expect_one_answer(const ref::Instance& instance, const ref::GroupAnalysis& analysis,
                       const std::string& written) {
  ref::TriangulationOptions options;
  options.order_seed = 1 + written.size();
  options.stages = ref::PredicateStages::exact_only;
  // The form for long lattices works with rationals: in space it is for few points only.
  if (instance.dimension == 2 || instance.points.size() <= 2) options.region_limit = 0;
  expect(triangulated(instance, analysis, options) == written,
         "the triangulation depends neither on the insertion order nor on the filter nor on how a star is "
         "found");
  options = {.insertion = ref::Insertion::covering};
  options.max_sheets = (instance.dimension == 2 ? kMaxCopiesInPlane : kMaxCopiesInSpace) /
                       static_cast<long>(instance.points.size());
  std::string covering;
  try {
    covering = triangulated(instance, analysis, options);
  } catch (const ref::LimitReached&) {
    return;
  }
  expect(covering == written, "both engines give the same answer");
}

void run(std::span<const std::uint8_t> bytes) {
  const Texts texts = texts_of(decode(bytes, kShape));
  const ref::Instance instance = ref::parse_instance(texts.instance, "instance");
  std::string written;
  try {
    const ref::GroupAnalysis analysis = ref::analyse(instance);
    written = triangulated(instance, analysis, {});
    expect_one_answer(instance, analysis, written);
  } catch (const ref::InvalidInput&) {
    return;  // the target `group` looks at these
  } catch (const ref::LimitReached&) {
    return;
  }
  const auto read = read_instance(texts.instance);
  expect(read.has_value(), "the checker reads what ref reads");
  const auto triangulation = read_triangulation(written, *read);
  expect(triangulation.has_value(), "the checker reads what ref writes");
  if (const auto verdict = judge(*read, *triangulation))
    expect(verdict->outcome == checker::Outcome::verified, "what ref writes is VERIFIED");
}

}  // namespace
}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  flatdt::fuzz::run({data, size});
  return 0;
}
