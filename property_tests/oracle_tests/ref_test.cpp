/// ref against the oracle: the same Delaunay tessellation up to ties, and the same answer to "manifold or
/// cover".
#include <gtest/gtest.h>

#include <iostream>

#include "fixture.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/families.hpp"
#include "oracle/compare.hpp"
#include "oracle/voronoi.hpp"

namespace flatdt::oracle {
namespace {

using oracle_tests::Answer;
using oracle_tests::answer_of_ref;
using oracle_tests::stems;
using oracle_tests::text_of;
using oracle_tests::with;

/// Everything in which ref's answer to an instance differs from the oracle's; empty if nothing.
std::string disagreement(const Answer& answer) {
  const Tessellation tessellation = delaunay_tessellation(answer.instance);
  std::string text = difference(answer.instance, tessellation, answer.triangulation);
  Rational largest = 0;
  for (const DelaunayCell& cell : tessellation.cells) largest = std::max(largest, cell.squared_radius);
  if (answer.result.empty_diameter_squared.mpq() != 4 * largest) text += " Delta^2 differs";
  if (answer.result.distinct_points != tessellation.representatives.size())
    text += " the number of points differs";
  const Existence existence = carries_triangulation(tessellation);
  const bool is_cover = answer.result.sheets != 1;
  if (is_cover != answer.result.reason.has_value()) text += " a cover without a reason, or the reverse";
  if (!is_cover && existence == Existence::no) text += " a triangulation of the manifold, which has none";
  const bool for_invariance = is_cover && answer.result.reason &&
                              answer.result.reason->kind == ref::StayedInCover::Kind::not_invariant;
  if (is_cover && !for_invariance && existence == Existence::yes)
    text += " a cover, though the manifold has one";
  return text;
}

TEST(RefAgainstOracle, AdversarialInstances) {
  for (const auto& stem : stems(FLATDT_CORPORA "/adversarial", ".instance"))
    EXPECT_EQ(disagreement(answer_of_ref(text_of(with(stem, ".instance")))), "") << stem;
}

/// Enough points for the manifold itself to carry the triangulation.
TEST(RefAgainstOracle, TriangulationsOfTheManifoldItself) {
  const auto generated = [](const char* manifold, const char* family, long n) {
    return ref::write_instance(generate(*ref::find_entry(manifold), manifold, family, n, 1));
  };
  std::vector<std::string> texts = {generated("torus", "uniform", 24),
                                    generated("klein-bottle", "uniform", 24),
                                    generated("torocosm", "grid", 27)};
  if (oracle_tests::setting("FLATDT_ORACLE_ROUNDS", 1) > 1)  // seconds each
    for (const char* name : {"dicosm-50", "tetracosm-45", "second-amphicosm-45", "first-amphidicosm-45"})
      texts.push_back(text_of(std::string(FLATDT_CORPORA "/valid/") + name + ".instance"));
  for (const std::string& text : texts) {
    const Answer answer = answer_of_ref(text);
    EXPECT_EQ(disagreement(answer), "") << text;
    EXPECT_EQ(answer.result.sheets, 1) << text;
  }
}

class EveryManifold : public testing::TestWithParam<std::string> {};

/// Instances of all families at both metrics, n from 1 to 8 in turn; in space a round takes every third
/// family and one of the metrics, so that six rounds have had all.
TEST_P(EveryManifold, GeneratedInstances) {
  const ref::CatalogueEntry& entry = *ref::find_entry(GetParam());
  const std::size_t rounds = oracle_tests::setting("FLATDT_ORACLE_ROUNDS", 1);
  const std::size_t stride = entry.dimension == 2 ? 1 : 6;
  const auto first = static_cast<std::size_t>(&entry - ref::catalogue().data());
  std::size_t compared = 0;
  std::size_t on_manifold = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t k = (first + round) % stride; k < 2 * ref::families().size(); k += stride) {
      const std::string& family = ref::families()[k / 2].name;
      const long n = 1 + static_cast<long>((k + first + round / stride) * 3 % 8);
      const std::string text = ref::write_instance(generate(
          entry, entry.name, family, n, 1000 + round, k % 2 == round / stride % 2 ? "canonical" : "random"));
      const Answer answer = answer_of_ref(text);
      EXPECT_EQ(disagreement(answer), "") << text;
      ++compared;
      on_manifold += answer.result.sheets == 1 ? 1 : 0;
    }
  }
  std::cout << GetParam() << ": " << compared << " instances compared, " << on_manifold
            << " on the manifold itself\n";
  EXPECT_GT(compared, 0U);
}

std::vector<std::string> manifold_names() {
  std::vector<std::string> names;
  for (const ref::CatalogueEntry& entry : ref::catalogue()) names.push_back(entry.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(RefAgainstOracle, EveryManifold, testing::ValuesIn(manifold_names()),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace flatdt::oracle
