/// Arbitrary generators and metrics: ref's analysis and the group conditions of the checker accept the same
/// groups, refuse the others for the same reason, and recognise the same manifold.
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

using checker::ConditionName;
using checker::Status;

enum class Finding { admissible, not_definite, not_crystallographic, torsion, wrong_name };

/// Nothing at a limit.
std::optional<Finding> by_ref(const ref::Instance& instance, std::optional<ref::GroupAnalysis>& analysis) {
  if (!ref::is_positive_definite(instance.gram)) return Finding::not_definite;
  try {
    analysis = ref::analyse(instance);
    return Finding::admissible;
  } catch (const ref::FixedPointError& error) {
    expect(!error.element().is_identity(), "the element of finite order is not the identity");
    expect(error.element() * error.point() == error.point(), "the point shown is fixed");
    return Finding::torsion;
  } catch (const ref::InvalidInput& error) {
    return error.section() == ref::InvalidInput::Section::manifold ? Finding::wrong_name
                                                                   : Finding::not_crystallographic;
  } catch (const ref::LimitReached&) {
    return std::nullopt;
  }
}

Finding by_checker(const checker::Verdict& verdict) {
  if (verdict[ConditionName::group_crystallographic].status != Status::holds)
    return Finding::not_crystallographic;
  if (verdict[ConditionName::group_torsion_free].status != Status::holds) return Finding::torsion;
  return verdict[ConditionName::group_name].status == Status::fails ? Finding::wrong_name
                                                                    : Finding::admissible;
}

std::string witness(const checker::Condition& condition, const std::string& key) {
  for (const auto& [name, value] : condition.witness)
    if (name == key) return value;
  return {};
}

void expect_one_group(const checker::Verdict& verdict, const ref::GroupAnalysis& analysis) {
  const checker::Condition& name = verdict[ConditionName::group_name];
  expect(name.status == Status::holds, "the checker confirms the manifold that ref recognises");
  expect(witness(name, "orientable") == (analysis.orientable ? "yes" : "no"),
         "both find it orientable or not");
  expect(witness(verdict[ConditionName::group_crystallographic], "linear-parts") ==
             std::to_string(analysis.holonomy_order),
         "both find as many linear parts");
}

}  // namespace
}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatdt::fuzz;
  const Texts texts = texts_of(decode({data, size}, kShape));
  const flatdt::ref::Instance instance = flatdt::ref::parse_instance(texts.instance, "instance");
  std::optional<flatdt::ref::GroupAnalysis> analysis;
  const std::optional<Finding> ours = by_ref(instance, analysis);
  auto read = read_instance(texts.instance);
  expect(read.has_value() == flatdt::ref::is_positive_definite(instance.gram),
         "only the metric can be malformed");
  if (!read || !ours) return 0;
  flatdt::checker::Triangulation nothing;
  nothing.dimension = read->dimension;
  if (analysis) {  // of an admissible group the checker has to confirm the name, claimed or not
    expect(!read->claim || *read->claim == analysis->entry->name, "a wrong name is refused");
    read->claim = analysis->entry->name;
  }
  const auto verdict = judge(*read, nothing);
  if (!verdict) return 0;
  expect(by_checker(*verdict) == *ours, "both sides find the same fault in a group, or none");
  if (analysis) expect_one_group(*verdict, *analysis);
  return 0;
}
