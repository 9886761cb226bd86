// The parts: command lines, children, capabilities files, claims of edges, the program's exit codes.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "command_template.hpp"
#include "edge_claim.hpp"
#include "fixture.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"

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

TEST(Options, DurationsHaveUnits) {
  EXPECT_EQ(parse_duration("90"), 90);
  EXPECT_EQ(parse_duration("1.5h"), 5400);
  EXPECT_EQ(parse_duration("10m"), 600);
  for (const char* wrong : {"", "m", "10 days", "-1", "inf"})
    EXPECT_THROW(parse_duration(wrong), UsageError) << wrong;
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

TEST(Child, ThatCannotBeStartedIsAnError) {
  EXPECT_THROW(run_child({"/no/such/program"}, "", "", "", {}), std::system_error);
}

TEST(Capabilities, AreReadAndRefused) {
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
  for (const char* wrong : {"[]", "{", R"({"manifolds": ["G1"]})", R"({"schema": "flatdt-capabilities 2"})",
                            R"({"schema": "flatdt-capabilities 1", "colour": 1})",
                            R"({"schema": "flatdt-capabilities 1", "manifolds": ["G7"]})",
                            R"({"schema": "flatdt-capabilities 1", "metrics": "euclidean"})"}) {
    write_text(path, wrong);
    EXPECT_THROW(static_cast<void>(read_capabilities(path)), std::runtime_error) << wrong;
  }
}

/// The edges of ref's triangulation, as a claim; `leave_out` of them missing, from the front.
std::string claim_of(const std::string& instance_text, std::size_t leave_out, const std::string& more) {
  const ref::Instance instance = ref::parse_instance(instance_text, "instance");
  const auto t = ref::triangulate(instance, ref::analyse(instance), {}).triangulation;
  std::ostringstream elements, edges;
  std::size_t count = 0;
  for (const ref::Isometry& g : t.elements) elements << g.to_string() << "\n";
  for (const auto& cell : t.cells)
    for (std::size_t a = 0; a <= static_cast<std::size_t>(t.dimension); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (++count > leave_out)
          edges << cell[a].point << " " << cell[a].element << " " << cell[b].point << " " << cell[b].element
                << "\n";
  if (!more.empty()) ++count;
  return "flatdt-edges 1\nelements " + std::to_string(t.elements.size()) + "\n" + elements.str() + "edges " +
         std::to_string(count - leave_out) + "\n" + edges.str() + more;
}

TEST(EdgeClaim, IsJudgedUpToTies) {
  const std::string generic =
      "flatdt-instance 1 dimension 2 manifold klein-bottle points 3 1/10 1/5 3/4 3/8 2/5 9/10 ";
  EXPECT_EQ(judge_edges(generic, claim_of(generic, 0, ""), 0).signature, "");
  EXPECT_EQ(judge_edges(generic, "flatdt-edges 1\nelements 0\nedges 0\n", 0).signature,
            "refuted edges.present");
  // Ties: one point on the square torus. The two sides of the square must be there, diagonals need not.
  const std::string square = "flatdt-instance 1 dimension 2 manifold torus points 1 0 0 ";
  const std::string head =
      "flatdt-edges 1\nelements 5\n1 0 0 0 1 0\n1 0 1 0 1 0\n1 0 0 0 1 1\n1 0 1 0 1 1\n1 0 2 0 1 0\n";
  EXPECT_EQ(judge_edges(square, head + "edges 2\n0 0 0 1\n0 0 0 2\n", 0).signature, "");
  EXPECT_EQ(judge_edges(square, head + "edges 3\n0 0 0 1\n0 0 0 2\n0 3 0 0\n", 0).signature, "");
  EXPECT_EQ(judge_edges(square, head + "edges 1\n0 0 0 1\n", 0).signature, "refuted edges.present");
  EXPECT_EQ(judge_edges(square, head + "edges 3\n0 0 0 1\n0 0 0 2\n0 0 0 4\n", 0).signature,
            "refuted edges.delaunay");
  EXPECT_EQ(judge_edges(square, head + "edges 1\n0 0 0 1\n", 2).signature, "")
      << "no facet is longer than 2 periods";
}

TEST(EdgeClaim, ElementsMustBeOfTheGroup) {
  const std::string square = "flatdt-instance 1 dimension 2 manifold torus points 1 0 0 ";
  EXPECT_EQ(judge_edges(square, "flatdt-edges 1\nelements 1\n1 0 1/2 0 1 0\nedges 0\n", 0).signature,
            "refuted edges.member");
}

TEST(EdgeClaim, MalformedFilesAreRefused) {
  const std::string square = "flatdt-instance 1 dimension 2 manifold torus points 1 0 0 ";
  for (const char* wrong :
       {"", "flatdt-edges 2\n", "flatdt-edges 1\nelements 0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1\nedges 0\n", "flatdt-edges 1\nelements 0\nedges 1\n0 0 0 0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1 0\nedges 1\n0 0 0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1 0\nedges 99999999999\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1 0\nedges 0\n0\n"})
    EXPECT_EQ(judge_edges(square, wrong, 0).signature, "malformed") << wrong;
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
  EXPECT_EQ(exit_code({"--points", "9..1"}), 2);
  EXPECT_EQ(exit_code({"--shard", "3/2"}), 2);
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
    EXPECT_NE(read_text(bundle + "/verdict.json").find("\"REFUTED\""), std::string::npos);
    EXPECT_NE(read_text(bundle + "/picture.svg").find("<svg"), std::string::npos);
  }
}

}  // namespace
}  // namespace flatdt::campaign
