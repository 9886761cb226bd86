// Cases are a function of seed and number; shards partition them; a campaign resumes.
#include <regex>
#include <set>

#include "fixture.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::campaign {
namespace {

Plan whole_plan() {
  Plan plan;
  plan.manifolds = testing::all_manifolds();
  plan.families = all_families();
  return plan;
}

std::string text_of_case(const Plan& plan, std::uint64_t number) {
  return ref::write_instance(testing::instance_of(draw_case(plan, number)));
}

/// FNV-1a, 64 bits.
std::uint64_t fingerprint(std::uint64_t hash, const std::string& text) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

std::set<std::uint64_t> case_numbers(const std::string& folder) {
  std::set<std::uint64_t> numbers;
  const std::regex number("\"case\":([0-9]+)");
  for (const std::string& line : result_lines(folder)) {
    std::smatch match;
    if (!std::regex_search(line, match, number)) continue;
    EXPECT_TRUE(numbers.insert(std::stoull(match[1])).second) << line;
  }
  return numbers;
}

TEST(Cases, AreAFunctionOfSeedAndNumber) {
  Plan plan = whole_plan();
  std::set<std::string> texts;
  for (std::uint64_t i = 0; i < 60; ++i) {
    EXPECT_EQ(text_of_case(plan, i), text_of_case(plan, i));
    texts.insert(text_of_case(plan, i));
  }
  EXPECT_GT(texts.size(), 55U);
  const std::string first = text_of_case(plan, 0);
  plan.seed = 2;
  EXPECT_NE(text_of_case(plan, 0), first);
}

// The same on every machine: this number was computed once. It changes only when families or drawing do, and
// then campaigns with old seeds meet other cases: say so where it is changed.
TEST(Cases, AreTheSameOnEveryMachine) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (std::uint64_t i = 0; i < 60; ++i) hash = fingerprint(hash, text_of_case(whole_plan(), i));
  EXPECT_EQ(hash, 16880969127251117240ULL);
}

TEST(Cases, KeepToTheNumbersOfPoints) {
  Plan plan = whole_plan();
  plan.min_points = 5;
  plan.max_points = 9;
  std::set<std::size_t> sizes;
  for (std::uint64_t i = 0; i < 200; ++i) sizes.insert(draw_case(plan, i).points.size());
  EXPECT_EQ(sizes, (std::set<std::size_t>{5, 6, 7, 8, 9}));
}

TEST(Cases, ConformToCapabilities) {
  Plan plan = whole_plan();
  plan.manifolds = {"torus", "klein-bottle", "torocosm", "didicosm", "second-amphicosm"};
  Capabilities& c = plan.capabilities;
  c.canonical_metric_only = c.doubles_only = c.names_only = c.distinct_only = true;
  std::set<std::string> families;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const testing::Specimen s = draw_case(plan, i);
    families.insert(s.family);
    EXPECT_TRUE(accepts(c, s)) << s;
  }
  EXPECT_EQ(families.size(), all_families().size());
}

TEST(Shards, PartitionTheCases) {
  std::set<std::uint64_t> all;
  std::size_t sum = 0;
  for (const std::uint64_t shard : {1, 2, 3}) {
    const Folder folder;
    Options options = small_campaign("right", true, folder.path());
    options.shard = shard;
    options.shards = 3;
    options.jobs = 2;
    options.cases = 20;
    EXPECT_TRUE(run(options).empty());
    const std::set<std::uint64_t> numbers = case_numbers(folder.path());
    sum += numbers.size();
    all.insert(numbers.begin(), numbers.end());
  }
  EXPECT_EQ(sum, 20U);
  EXPECT_EQ(all.size(), 20U);
  EXPECT_EQ(*all.rbegin(), 19U);
}

TEST(Resume, MeetsTheRemainingCasesOnce) {
  const Folder folder, whole;
  Options options = small_campaign("abort", true, folder.path());
  options.minimise_each = 1;
  options.cases = 6;
  run(options);
  // As if the campaign had been stopped while it wrote.
  const std::string path = folder.path() + "/results.jsonl";
  std::string text = read_text(path);
  write_text(path, text.substr(0, text.size() - 5));
  options.cases = 12;
  const std::vector<Group> resumed = run(options, true);
  EXPECT_EQ(case_numbers(folder.path()).size(), 12U);
  options.out = whole.path();
  const std::vector<Group> at_once = run(options);
  ASSERT_EQ(resumed.size(), at_once.size());
  for (std::size_t i = 0; i < resumed.size(); ++i) {
    EXPECT_EQ(resumed[i].signature, at_once[i].signature);
    EXPECT_EQ(resumed[i].failures.size(), at_once[i].failures.size());
  }
}

TEST(Resume, RefusesAnotherCampaignAndAForgottenOne) {
  const Folder folder;
  Options options = small_campaign("right", true, folder.path());
  options.cases = 2;
  run(options);
  EXPECT_THROW(run(options), std::runtime_error) << "results are not overwritten";
  options.plan.seed = 99;
  EXPECT_THROW(run(options, true), std::runtime_error);
}

TEST(Groups, AreOfOneSignatureAndOneForm) {
  Result a;
  a.outcome = "wrong";
  a.signature = "malformed";
  a.form = "torus";
  a.shrunk_points = 4;
  a.bundle = "x";
  Result b = a, c = a, d = a;
  a.number = 3;
  b.number = 1;
  b.form.clear();
  b.bundle.clear();
  c.number = 2;
  c.shrunk_points = 2;
  d.number = 4;
  d.signature = "time limit";
  std::vector<Group> groups = grouped({a, b, c, d});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].failures.size(), 3U) << "one that was not minimised counts with the only form there is";
  EXPECT_EQ(groups[0].failures.front().number, 2U) << "the one with the fewest points speaks for the group";
  EXPECT_EQ(title(groups[0]), "torus, 2 points or more");
  EXPECT_EQ(title(groups[1]), "torus, 4 points");
  c.form = "torus, another metric";
  EXPECT_EQ(grouped({a, b, c, d}).size(), 2U) << "what is shown without another metric needs none";
  c.form = "klein-bottle";
  groups = grouped({a, b, c, d});
  EXPECT_EQ(groups.size(), 4U) << "with two forms it is not known which,";
  b.manifold = "klein-bottle";
  EXPECT_EQ(grouped({a, b, c, d}).size(), 3U) << "unless one is of its manifold";
}

}  // namespace
}  // namespace flatdt::campaign
