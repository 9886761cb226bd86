// Every kind of wrong implementation is found, shrunk to few points, and is one line of the report.
#include "fixture.hpp"
#include "report.hpp"

namespace flatdt::campaign {
namespace {

struct Flaw {
  std::string way;
  bool persistent;
  std::string signature;
  std::size_t most_points;
  std::uint64_t cases;
};

void PrintTo(const Flaw& flaw, std::ostream* out) {
  *out << flaw.way << (flaw.persistent ? ", persistent" : "");
}

std::size_t points_in(const std::string& instance) {
  const std::size_t at = instance.find("points ");
  return at == std::string::npos ? 0 : std::stoul(instance.substr(at + 7));
}

class FlawTest : public ::testing::TestWithParam<Flaw> {};

TEST_P(FlawTest, IsFoundShrunkAndOneLine) {
  const Flaw& flaw = GetParam();
  const Folder folder;
  Options options = small_campaign(flaw.way, flaw.persistent, folder.path());
  options.cases = flaw.cases;
  // Sanitizers keep what a program frees.
  if (flaw.way != "memory") options.contact.limits.memory_bytes = std::uint64_t{2} << 30;
  if (flaw.way == "hang" || flaw.way == "memory") {  // each run of the shrinking costs what the limit allows
    options.contact.limits.cpu_seconds = flaw.way == "hang" ? 0.3 : 10;
    options.minimise_each = 1;
    options.budget.runs = 10;
  }
  const std::vector<Group> groups = run(options);
  ASSERT_EQ(groups.size(), 1U) << html_report(options, Ledger(folder.path(), describe(options), true));
  EXPECT_EQ(groups[0].signature, flaw.signature);
  ASSERT_FALSE(groups[0].failures.front().bundle.empty());
  const std::string bundle = folder.path() + "/" + groups[0].failures.front().bundle;
  const std::string shrunk = read_text(bundle + "/instance");
  EXPECT_LE(points_in(shrunk), flaw.most_points) << shrunk;
  EXPECT_NE(shrunk.find("manifold torus"), std::string::npos) << "the simplest manifold fails too\n"
                                                              << shrunk;
  EXPECT_FALSE(read_text(bundle + "/reproduce").empty());
  EXPECT_EQ(result_lines(folder.path()).size(), flaw.cases) << "the campaign goes on after a failure";
}

INSTANTIATE_TEST_SUITE_P(
    Flaws, FlawTest,
    ::testing::Values(Flaw{"drop-cell", true, "refuted facets.paired volume.exact", 1, 8},
                      Flaw{"flip", true, "refuted delaunay.empty", 15, 60},
                      Flaw{"abort", true, "signal SIGABRT", 5, 8},
                      Flaw{"abort", false, "signal SIGABRT", 5, 8}, Flaw{"hang", true, "time limit", 20, 3},
                      Flaw{"hang", false, "time limit", 20, 3}, Flaw{"memory", true, "memory limit", 20, 3},
                      Flaw{"flood", true, "output limit", 1, 2}, Flaw{"flood", false, "output limit", 1, 2},
                      Flaw{"garbage", true, "malformed", 1, 3}, Flaw{"exit-7", true, "exit status 7", 1, 2},
                      Flaw{"exit-7", false, "exit status 7", 1, 2}, Flaw{"forget", false, "no output", 1, 2},
                      Flaw{"pipe", false, "no output", 1, 2}, Flaw{"link", false, "no output", 1, 2},
                      Flaw{"folder", false, "no output", 1, 2}));

TEST(Campaign, FindsNothingWhereNothingIs) {
  for (const bool persistent : {false, true}) {
    const Folder folder;
    EXPECT_TRUE(run(small_campaign("right", persistent, folder.path())).empty());
    EXPECT_EQ(result_lines(folder.path()).size(), 10U);
  }
}

TEST(Campaign, CountsUnsupportedApart) {
  for (const bool persistent : {false, true}) {
    const Folder folder;
    Options options = small_campaign("unsupported", persistent, folder.path());
    options.plan.manifolds = {"torus", "torocosm"};
    options.plan.max_points = 2;
    Ledger ledger(options.out, describe(options), false);
    run_campaign(options, ledger, false);
    EXPECT_EQ(ledger.total().wrong, 0U);
    EXPECT_GT(ledger.total().unsupported, 0U);
    EXPECT_GT(ledger.total().right, 0U);
    EXPECT_NE(junit_report(options, ledger).find("<skipped"), std::string::npos);
  }
}

TEST(Campaign, ReportsNameTheFailureAndItsPlace) {
  const Folder folder;
  Options options = small_campaign("drop-cell", true, folder.path());
  options.cases = 4;
  Ledger ledger(options.out, describe(options), false);
  run_campaign(options, ledger, false);
  const std::string html = html_report(options, ledger), junit = junit_report(options, ledger);
  EXPECT_NE(html.find("4 &times; refuted facets.paired volume.exact: torus, 1 point<"), std::string::npos)
      << html;
  EXPECT_NE(html.find("manifold torus\nmetric 1 0 1\npoints 1\n"), std::string::npos);
  EXPECT_EQ(html.find("src=\"http"), std::string::npos) << "self-contained";
  EXPECT_NE(junit.find("<failure message=\"refuted facets.paired volume.exact\">"), std::string::npos)
      << junit;
  EXPECT_NE(text_summary(options, ledger).find("4 x refuted facets.paired volume.exact: torus, 1 point: "),
            std::string::npos);
}

}  // namespace
}  // namespace flatdt::campaign
