/// Instances: what ref finds is a Delaunay triangulation for the checker, and does not depend on ref's
/// internal choices: both engines, every order, with and without the filter.
#include "flatdt/ref/triangulate.hpp"
#include "../engine/expect.hpp"
#include "../engine/laws.hpp"
#include "../engine/target.hpp"
#include "../specimen/known_group.hpp"
#include "../specimen/quotient.hpp"
#include "../specimen/structured_target.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "judged.hpp"

namespace flatdt::fuzz {

const Shape kShape = {};

namespace {

using checker::ConditionName;
using checker::Status;

/// The laws that are not asked of every input.
enum Law : std::uint64_t { kChoices = 1, kLongLattice, kAnswer, kCovering };

/// Copies of points up to which the covering engine is asked as well: each costs an insertion.
constexpr long kMaxCopiesInPlane = 200;
constexpr long kMaxCopiesInSpace = 80;

/// Copies of points that the written answer has at most: 3^d sheets for each linear part.
std::uint64_t most_copies(const ref::Instance& instance, const ref::PreparedGroup& group) {
  return instance.points.size() * group.frame().cosets.size() * (instance.dimension == 2 ? 9U : 27U);
}

/// The cells modulo H tile space and are Delaunay; loops and 2-cycles are there where ref says so. All that
/// is not skipped but these and what follows from them holds: docs/soundness.md, section 6.
void expect_delaunay_tiling(const Quotient& quotient, const checker::Verdict& verdict) {
  using enum ConditionName;
  const bool no_short_cycle = verdict[skeleton_no_loop].status == Status::holds &&
                              verdict[skeleton_no_2_cycle].status == Status::holds;
  expect(quotient.simplicial.value_or(no_short_cycle) == no_short_cycle, "both find loops and 2-cycles");
  expect((verdict.outcome == checker::Outcome::verified) == no_short_cycle,
         "the triangulation of the manifold is VERIFIED iff it has no loop or 2-cycle");
  for (std::size_t k = 0; k < checker::kConditionCount; ++k) {
    const auto name = static_cast<ConditionName>(k);
    const bool of_complexes = name == simplices_injective || name == skeleton_no_loop ||
                              name == skeleton_no_2_cycle || name == complex_intersection;
    const bool may_be_skipped = name == group_name || name == topology_homology;
    const Status status = verdict[name].status;
    if (status != Status::holds && !of_complexes && !(may_be_skipped && status == Status::skipped))
      expect(false, "the cells modulo the group are a Delaunay tiling: " + std::string(to_string(name)));
  }
}

std::string triangulated(const ref::Instance& instance, const ref::PreparedGroup& group,
                         const ref::TriangulationOptions& options) {
  const ref::TriangulationResult result = ref::triangulate(instance, group, options);
  return ref::write_triangulation(result.triangulation, ref::describe(result));
}

/// The file that the program would write, with other choices inside than those of `quotient`.
void expect_verified(const ref::Instance& instance, const ref::PreparedGroup& group, const Quotient& quotient,
                     const checker::Instance& read) {
  ref::TriangulationOptions options;
  options.order_seed = 1 + quotient.triangulation.cells.size();
  const ref::TriangulationResult result = ref::triangulate(instance, group, options);
  if (quotient.simplicial)
    expect(result.reason.has_value() != *quotient.simplicial,
           "a cover is written where the manifold has loops or 2-cycles");
  const std::string written = ref::write_triangulation(result.triangulation, ref::describe(result));
  const auto triangulation = read_triangulation(written, read);
  expect(triangulation.has_value(), "the checker reads what ref writes");
  if (const auto verdict = judge(read, *triangulation))
    expect(verdict->outcome == checker::Outcome::verified, "what ref writes is VERIFIED");
}

void expect_one_answer_of_both_engines(const ref::Instance& instance, const ref::PreparedGroup& group) {
  ref::TriangulationOptions options = {.insertion = ref::Insertion::covering};
  options.max_sheets = (instance.dimension == 2 ? kMaxCopiesInPlane : kMaxCopiesInSpace) /
                       static_cast<long>(instance.points.size());
  std::string covering;
  try {
    covering = triangulated(instance, group, options);
  } catch (const ref::LimitReached&) {
    return;
  }
  expect(covering == triangulated(instance, group, {}), "both engines give the same answer");
}

std::string text_of(const Quotient& quotient) {
  return ref::write_triangulation(quotient.triangulation, {});
}

void expect_laws(std::span<const std::uint8_t> bytes, const ref::Instance& instance,
                 const ref::PreparedGroup& group) {
  const Quotient found = quotient(instance, group);
  const auto read = read_instance(ref::write_instance(instance));
  expect(read.has_value(), "the checker reads what ref reads");
  if (const auto verdict = judge(*read, for_checker(found.triangulation)))
    expect_delaunay_tiling(found, *verdict);

  if (is_asked(bytes, kChoices, 4))
    expect(text_of(quotient(instance, group,
                            {.first = found.triangulation.cells.size(),
                             .stages = ref::PredicateStages::exact_only})) == text_of(found),
           "the triangulation depends neither on the insertion order nor on the filter");
  // The form for long lattices works with rationals: in space it is for few points only.
  if ((instance.dimension == 2 || instance.points.size() <= 2) && is_asked(bytes, kLongLattice, 8))
    expect(text_of(quotient(instance, group, {.region_limit = 0})) == text_of(found),
           "the triangulation does not depend on how a star is found");
  // The dearer the answer may be, the seldomer: so that each input costs about as much.
  const std::uint64_t dearness = 1 + most_copies(instance, group) / 8;
  if (is_asked(bytes, kAnswer, dearness)) expect_verified(instance, group, found, *read);
  if (is_asked(bytes, kCovering, 4 * dearness)) expect_one_answer_of_both_engines(instance, group);
}

}  // namespace
}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatdt;
  const ref::Instance instance = fuzz::instance_of(fuzz::decode({data, size}, fuzz::kShape));
  try {
    fuzz::expect_laws({data, size}, instance, *fuzz::prepared(instance));
  } catch (const ref::InvalidInput&) {  // the target `group` looks at these
  } catch (const ref::LimitReached&) {
  }
  return 0;
}
