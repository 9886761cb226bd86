/// ref against the oracle: the same Delaunay tessellation up to ties, and the same answer to "manifold or
/// cover".
#include <gtest/gtest.h>

#include <array>
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

class EveryManifold : public testing::TestWithParam<std::string> {};

/// Instances of every family at both metrics, n from 1 to 8 in turn.
TEST_P(EveryManifold, GeneratedInstances) {
  const ref::CatalogueEntry& entry = *ref::find_entry(GetParam());
  std::size_t compared = 0;
  std::size_t beyond_limit = 0;
  std::size_t on_manifold = 0;
  const std::uint64_t rounds = entry.dimension == 2 ? FLATDT_PLANE_ROUNDS : FLATDT_SPACE_ROUNDS;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < ref::families().size(); ++k) {
      for (const std::string metric : {"canonical", "random"}) {
        const long n = 1 + static_cast<long>((3 * k + round + (metric == "random" ? 5 : 0)) % 8);
        const std::string text = ref::write_instance(
            generate(entry, entry.name, ref::families()[k].name, n, 1000 + round, metric));
        try {
          const Answer answer = answer_of_ref(text);
          EXPECT_EQ(disagreement(answer), "") << text;
          ++compared;
          on_manifold += answer.result.sheets == 1 ? 1 : 0;
        } catch (const ref::LimitReached&) {
          ++beyond_limit;
        }
      }
    }
  }
  std::cout << GetParam() << ": " << compared << " instances compared, " << on_manifold
            << " on the manifold itself, " << beyond_limit << " beyond ref's limit of sheets\n";
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
