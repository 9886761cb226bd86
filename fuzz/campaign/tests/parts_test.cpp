// The parts: command lines, children, capabilities, the program's exit codes, bundles.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <thread>

#include "command_template.hpp"
#include "fixture.hpp"

namespace flatdt::campaign {
namespace {

using Words = std::vector<std::string>;

TEST(CommandTemplate, SplitsAsShellsDo) {
  EXPECT_EQ(split_command("a  'b c' \"d\\\" e\" f\\ g ''"), (Words{"a", "b c", "d\" e", "f g", ""}));
  EXPECT_THROW(static_cast<void>(split_command("a 'b")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(split_command("  ")), std::invalid_argument);
  EXPECT_EQ(filled({"x", "--in={instance}", "{output}"}, "/i", "/o"), (Words{"x", "--in=/i", "/o"}));
  EXPECT_EQ(split_command(shell_line({"a b", "it's", ""})), (Words{"a b", "it's", ""}));
}

TEST(CommandTemplate, PlacesStandOutsideOfQuotesInLinesForSh) {
  EXPECT_EQ(shell_line({"a", "--in={instance}", "{output}{output}", ""}, "I", "O"), "a --in=I OO ''");
  // An apostrophe before the place, and one behind it.
  EXPECT_EQ(shell_line({"cat '{instance}' x"}, "\"$i\"", ""), R"('cat '\'''"$i"''\'' x')");
}

TEST(Child, LeavesNothingBehind) {
  const Folder folder;
  const std::string out = folder.path() + "/pid";
  Limits limits;
  limits.address_bytes = 0;
  const End end = run_child({"sh", "-c", "sleep 1000 & echo $!"}, "", out, "", limits);
  EXPECT_EQ(end.ending, Ending::exited);
  const pid_t grandchild = std::stoi(read_text(out));
  // It was killed; whoever inherits it may need a moment to see that.
  bool gone = false;
  for (int i = 0; i < 500 && !gone; ++i) {
    std::ifstream status("/proc/" + std::to_string(grandchild) + "/stat");
    std::string line;
    gone = !std::getline(status, line) || line.find(") Z") != std::string::npos;
    if (!gone) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(gone);
}

/// A program may leave anything where its files were; a pipe must not be waited for.
TEST(Child, ThatMakesPipesOfItsFilesIsNotWaitedFor) {
  const Folder folder;
  const std::string path = folder.path() + "/case.errors";
  write_text(path, "0123456789");
  EXPECT_EQ(read_tail(path, 4), "6789");
  EXPECT_EQ(read_tail(path, 40), "0123456789");
  std::filesystem::create_symlink(path, folder.path() + "/link");
  EXPECT_EQ(read_tail(folder.path() + "/link", 4), "");
  Contact contact;
  contact.limits.address_bytes = 0;
  contact.command = {"sh", "-c",
                     "cd '" + folder.path() + "' && rm -f case.* && " +
                         "mkfifo case.errors case.instance case.triangulation && echo made >made"};
  const std::unique_ptr<Implementation> program = make_one_shot(contact, folder.path());
  for (int run = 0; run < 2; ++run) {
    std::filesystem::remove(folder.path() + "/made");
    EXPECT_EQ(program->answer("").text, "");
    EXPECT_EQ(read_text(folder.path() + "/made"), "made\n");
  }
}

TEST(Child, ThatCannotBeStartedIsAnError) {
  EXPECT_THROW(run_child({"/no/such/program"}, "", "", "", {}), std::system_error);
}

TEST(Capabilities, AreRead) {
  const Folder folder;
  const std::string path = folder.path() + "/c.json";
  write_text(path, R"({"schema": "flatdt-capabilities 1", "manifolds": ["G1"], "coordinates": "doubles",
                       "max_points": {"3": 10}, "claims": "edges"})");
  const Capabilities c = read_capabilities(path);
  EXPECT_TRUE(c.doubles_only);
  EXPECT_EQ(c.claim, Claim::edges);
  testing::Specimen s = testing::empty_specimen("torocosm");
  s.points.assign(10, ref::Vector(3));
  EXPECT_TRUE(accepts(c, s));
  s.points.emplace_back(3);
  EXPECT_FALSE(accepts(c, s));
}

int exit_code(const Words& arguments) {
  Words words{FLATDT_CAMPAIGN};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Limits limits;
  limits.address_bytes = 0;
  const End end = run_child(words, "", "", "", limits);
  return end.ending == Ending::exited ? end.code : -1;
}

TEST(Program, ExitCodesSayWhatHappened) {
  const Folder folder;
  const auto against = [&](const std::string& way, const std::string& out) {
    return exit_code({"--against", std::string(FLATDT_FLAWED) + " " + way + " --loop", "--persistent",
                      "--cases", "2", "--manifold", "torus", "--points", "1..3", "--family", "uniform",
                      "--address-limit", "0", "--out", folder.path() + "/" + out});
  };
  EXPECT_EQ(against("right", "a"), 0);
  EXPECT_EQ(against("right", "a"), 2) << "the folder has results";
  EXPECT_EQ(against("garbage", "b"), 1);
  for (const char* report : {"results.jsonl", "junit.xml", "report.html", "summary.txt"})
    EXPECT_FALSE(read_text(folder.path() + "/b/" + report).empty()) << report;
  EXPECT_EQ(exit_code({"--manifold", "moebius"}), 2);
  EXPECT_EQ(exit_code({"--family", "large"}), 2);
  EXPECT_EQ(exit_code({"--against", "/no/such/program", "--cases", "1", "--out", folder.path() + "/c"}), 3);
  EXPECT_EQ(exit_code({"--help"}), 0);
  // What is not of a campaign is not touched.
  std::filesystem::create_directory(folder.path() + "/other");
  write_text(folder.path() + "/other/results.jsonl", "{\"precious\": 1}");
  EXPECT_EQ(exit_code({"--resume", "--cases", "1", "--out", folder.path() + "/other"}), 2);
  EXPECT_EQ(read_text(folder.path() + "/other/results.jsonl"), "{\"precious\": 1}");
}

TEST(Program, TestsTheReferenceUnlessToldOtherwise) {
  const Folder folder;
  EXPECT_EQ(exit_code({"--flatdt", FLATDT_REFERENCE, "--cases", "3", "--points", "1..3", "--manifold",
                       "G1,pg", "--address-limit", "0", "--out", folder.path() + "/a"}),
            0);
  EXPECT_EQ(result_lines(folder.path() + "/a").size(), 3U);
}

TEST(Bundle, ReproducesTheFailure) {
  const Folder folder;
  for (const bool persistent : {false, true}) {
    Options options = small_campaign("drop-cell", persistent, folder.path() + (persistent ? "/p" : "/o"));
    std::filesystem::create_directories(options.out);
    options.cases = 1;
    options.flatdt = FLATDT_REFERENCE;
    const std::vector<Group> groups = run(options);
    ASSERT_EQ(groups.size(), 1U);
    const std::string bundle = options.out + "/" + groups[0].failures[0].bundle;
    const std::string output = folder.path() + "/said";
    Limits limits;
    limits.address_bytes = 0;
    const End end =
        run_child({"env", "FLATDT_CHECK=" FLATDT_CHECK, "sh", bundle + "/reproduce"}, "", output, "", limits);
    EXPECT_EQ(end.code, 1) << read_text(bundle + "/reproduce") << read_text(output);
    EXPECT_NE(read_text(output).find("s REFUTED"), std::string::npos) << read_text(output);
    EXPECT_NE(read_text(bundle + "/picture.svg").find("facets.paired"), std::string::npos) << "the witness";
    EXPECT_NE(read_text(bundle + "/verdict.json").find("\"REFUTED\""), std::string::npos);
    EXPECT_NE(read_text(bundle + "/picture.svg").find("<svg"), std::string::npos);
  }
}

TEST(Bundle, ReproducesCrashesOfPersistentCommands) {
  const Folder folder;
  Options options = small_campaign("abort", true, folder.path());
  options.cases = 8;
  options.minimise_each = 1;
  const std::vector<Group> groups = run(options);
  ASSERT_EQ(groups.size(), 1U);
  const std::string output = folder.path() + "/said";
  Limits limits;
  limits.address_bytes = 0;
  const End end = run_child({"sh", options.out + "/" + groups[0].failures[0].bundle + "/reproduce"}, "",
                            output, "", limits);
  EXPECT_EQ(end.code, 128 + SIGABRT) << read_text(output);
  EXPECT_NE(read_text(output).find("exit status 134"), std::string::npos) << read_text(output);
}

}  // namespace
}  // namespace flatdt::campaign
