/// Instances: what ref writes is VERIFIED, and does not depend on its internal choices.
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

/// Copies of points that one input may ask for: each costs an insertion, with sanitizers some 0.1 ms in the
/// plane and 1 ms in space.
constexpr long kMaxCopiesInPlane = 1000;
constexpr long kMaxCopiesInSpace = 300;

std::string triangulated(const ref::Instance& instance, const ref::GroupAnalysis& analysis,
                         const ref::TriangulationOptions& options) {
  const ref::TriangulationResult result = ref::triangulate(instance, analysis, options);
  return ref::write_triangulation(result.triangulation, ref::describe(result));
}

void run(std::span<const std::uint8_t> bytes) {
  const Texts texts = texts_of(decode(bytes, kShape));
  const ref::Instance instance = ref::parse_instance(texts.instance, "instance");
  const auto points = static_cast<long>(instance.points.size());
  ref::TriangulationOptions options;
  options.max_sheets = (instance.dimension == 2 ? kMaxCopiesInPlane : kMaxCopiesInSpace) / points;
  std::string written;
  try {
    const ref::GroupAnalysis analysis = ref::analyse(instance);
    written = triangulated(instance, analysis, options);
    if (instance.dimension == 2) {
      options.order_seed = 1 + bytes.size();
      options.stages = ref::PredicateStages::exact_only;
      expect(triangulated(instance, analysis, options) == written,
             "the triangulation depends neither on the insertion order nor on the filter");
    }
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
