/// The naive checker on cases computed by hand, and that a disagreement is reported.
#include <gtest/gtest.h>

#include <array>

#include "fixture.hpp"
#include "flatdt/checker/check.hpp"
#include "naive_checker/abelian.hpp"
#include "naive_checker/group_facts.hpp"
#include "naive_checker/naive_check.hpp"

namespace flatdt::naive {
namespace {

using checker::ConditionName;
using checker::Outcome;
using checker::Status;
using oracle_tests::read_instance;
using oracle_tests::read_triangulation;
using oracle_tests::text_of;

TEST(Abelian, QuotientsByHand) {
  EXPECT_EQ(quotient(3, {}), (AbelianGroup{3, {}}));
  EXPECT_EQ(quotient(2, {{{0, 2}}, {{1, 3}}}), (AbelianGroup{0, {6}}));
  EXPECT_EQ(quotient(2, {{{0, 4}}, {{1, 6}}}), (AbelianGroup{0, {2, 12}}));
  EXPECT_EQ(quotient(2, {{{0, 2}, {1, 4}}, {{0, 6}, {1, 8}}}), (AbelianGroup{0, {2, 4}}));  // det -8, gcd 2
  EXPECT_EQ(quotient(3, {{{0, 6}, {1, 10}, {2, 15}}}), (AbelianGroup{2, {}}));              // gcd 1
  EXPECT_EQ(quotient(2, {{{0, 5}, {1, -5}}, {{0, -5}, {1, 5}}, {{0, 0}}}), (AbelianGroup{1, {5}}));
}

std::optional<oracle::Group> group_of(const checker::Instance& instance) {
  return oracle::generated_group(instance.dimension, instance.generators, instance.metric);
}

TEST(GroupFacts, NamesOfTheCatalogue) {
  const std::array<const char*, 2> plane = {"torus", "klein-bottle"};
  const std::array<const char*, 10> space = {
      "torocosm", "dicosm",          "tricosm",          "tetracosm",         "hexacosm",
      "didicosm", "first-amphicosm", "second-amphicosm", "first-amphidicosm", "second-amphidicosm"};
  const auto recognised = [](const std::string& name, const std::string& rest) {
    const auto group = group_of(read_instance("flatdt-instance 1 dimension " + rest + " manifold " + name +
                                              " points 1 0 0" + (rest == "3" ? " 0\n" : "\n")));
    return group && is_torsion_free(*group) ? manifold_name(*group) : "";
  };
  for (const char* name : plane) EXPECT_EQ(recognised(name, "2"), name);
  for (const char* name : space) EXPECT_EQ(recognised(name, "3"), name);
  for (const auto& [alias, name] : {std::pair{"P32", "tricosm"}, {"P43", "tetracosm"}, {"P65", "hexacosm"}})
    EXPECT_EQ(recognised(alias, "3"), name);
}

TEST(GroupFacts, Torsion) {
  const auto is_free = [](const std::string& generators) {
    const auto group =
        group_of(read_instance("flatdt-instance 1 dimension 2 generators " + generators + " points 1 0 0\n"));
    EXPECT_TRUE(group.has_value());
    return group && is_torsion_free(*group);
  };
  EXPECT_TRUE(is_free("2 1 0 1 0 1 0  -1 0 0 0 1 1/2"));                   // pg
  EXPECT_FALSE(is_free("3 1 0 1 0 1 0  1 0 0 0 1 1  -1 0 0 0 1 0"));       // pm
  EXPECT_FALSE(is_free("3 1 0 1 0 1 0  1 0 0 0 1 1  -1 0 1/3 0 -1 1/7"));  // p2
  EXPECT_FALSE(is_free("3 1 0 1 0 1 0  1 0 0 0 1 1  0 1 1/2 1 0 1/2"));    // cm: a glide and a reflection
}

class SquareTorus : public testing::Test {
 protected:
  [[nodiscard]] Report judged(const std::string& rest) const {
    return naive_check(instance_, read_triangulation("flatdt-triangulation 1 " + rest + "\n", instance_));
  }
  checker::Instance instance_ = read_instance("flatdt-instance 1 dimension 2 manifold torus points 1 0 0\n");
};

std::vector<ConditionName> failing(const Report& report) {
  std::vector<ConditionName> names;
  for (std::size_t k = 0; k < checker::kConditionCount; ++k)
    if (report.status[k] == Status::fails) names.push_back(static_cast<ConditionName>(k));
  return names;
}

const char* const kCorners =
    "elements 5  1 0 0 0 1 0  1 0 1 0 1 0  1 0 0 0 1 1  1 0 1 0 1 1  1 0 2 0 1 1 cells ";

/// The files (a) and (b) of docs/format.md, section 7.
TEST_F(SquareTorus, PartitionsIntoTwoTriangles) {
  using enum ConditionName;
  const std::vector<ConditionName> not_simplicial = {simplices_injective, skeleton_no_loop,
                                                     skeleton_no_2_cycle, complex_intersection};
  const Report weakly_delaunay = judged(std::string(kCorners) + "2  0 0 0 1 0 3  0 0 0 3 0 2");
  EXPECT_EQ(failing(weakly_delaunay), not_simplicial);
  EXPECT_TRUE(weakly_delaunay.contradictions.empty());
  ASSERT_TRUE(weakly_delaunay.definitions.has_value());
  EXPECT_TRUE(weakly_delaunay.definitions->tiling);
  EXPECT_TRUE(weakly_delaunay.definitions->vertices);
  EXPECT_TRUE(weakly_delaunay.definitions->delaunay);
  EXPECT_FALSE(weakly_delaunay.definitions->complex);

  std::vector<ConditionName> slanted = not_simplicial;
  slanted.insert(slanted.begin(), delaunay_empty);
  const Report not_delaunay = judged(std::string(kCorners) + "2  0 0 0 1 0 4  0 0 0 4 0 3");
  EXPECT_EQ(failing(not_delaunay), slanted);
  ASSERT_TRUE(not_delaunay.definitions.has_value());
  EXPECT_TRUE(not_delaunay.definitions->tiling);
  EXPECT_FALSE(not_delaunay.definitions->delaunay);
}

/// A cell that names one vertex twice: the halves of the square beside it are paired among themselves.
TEST_F(SquareTorus, ARepeatedVertexHasNoFacets) {
  for (const char* extra : {"0 0 0 0 0 1", "0 0 0 1 0 1", "0 3 0 3 0 3"}) {
    const std::string rest = std::string(kCorners) + "3  0 0 0 1 0 3  0 0 0 3 0 2  " + extra;
    const Report report = judged(rest);
    EXPECT_EQ(report[ConditionName::facets_paired], Status::fails);
    EXPECT_EQ(report[ConditionName::cells_nondegenerate], Status::fails);
    const checker::Verdict verdict =
        check(instance_, read_triangulation("flatdt-triangulation 1 " + rest + "\n", instance_));
    EXPECT_EQ(disagreement(report, verdict), "") << extra;
  }
}

TEST_F(SquareTorus, DisagreementsAreReported) {
  const checker::Triangulation triangulation = read_triangulation(
      "flatdt-triangulation 1 " + std::string(kCorners) + "2  0 0 0 1 0 3  0 0 0 3 0 2\n", instance_);
  const Report report = naive_check(instance_, triangulation);
  const checker::Verdict right = check(instance_, triangulation);
  EXPECT_EQ(disagreement(report, right), "");
  for (std::size_t k = 0; k < checker::kConditionCount; ++k) {
    checker::Verdict wrong = right;
    const auto name = static_cast<ConditionName>(k);
    wrong[name].status = wrong[name].status == Status::holds ? Status::fails : Status::holds;
    EXPECT_NE(disagreement(report, wrong).find(to_string(name)), std::string::npos);
  }
  checker::Verdict wrong = right;
  wrong.outcome = Outcome::verified;
  EXPECT_NE(disagreement(report, wrong).find("outcome"), std::string::npos);
  Report contradictory = report;
  contradictory.contradictions.emplace_back("one thing");
  EXPECT_NE(disagreement(contradictory, right).find("one thing"), std::string::npos);
}

/// The record of a file is not what it is for another one: the comparison of corpora can fail.
TEST(NaiveChecker, DefinitionsTellAFlipFromTheOriginal) {
  const std::string folder = FLATDT_CORPORA "/invalid/delaunay.empty/klein-flip";
  const checker::Instance instance = read_instance(text_of(folder + ".instance"));
  const Report report =
      naive_check(instance, read_triangulation(text_of(folder + ".triangulation"), instance));
  ASSERT_TRUE(report.definitions.has_value());
  EXPECT_TRUE(report.definitions->tiling);
  EXPECT_FALSE(report.definitions->delaunay);
  EXPECT_FALSE(report.definitions->all());
  EXPECT_EQ(failing(report), std::vector<ConditionName>{ConditionName::delaunay_empty});
}

}  // namespace
}  // namespace flatdt::naive
