// Claims of edges: right ones are accepted whatever the ties, and no edge can be missing.
#include "edge_claim.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "delaunay_graph.hpp"
#include "fixture.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"

namespace flatdt::campaign {
namespace {

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

/// What another program wrote, with the condition that its third line names: docs/findings.md.
TEST(EdgeClaim, FindingsAreRefuted) {
  const auto text_of = [](const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  };
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FLATDT_CORPORA "/findings")) {
    std::filesystem::path path = entry.path();
    if (path.extension() != ".edges") continue;
    ++found;
    SCOPED_TRACE(path);
    const std::string claim = text_of(path);
    const Judgement judgement =
        judge_edges(text_of(path.replace_extension(".instance")), claim, ref::Rational(1, 1 << 16));
    ASSERT_EQ(judgement.signature.rfind("refuted ", 0), 0U) << judgement.signature;
    EXPECT_NE(claim.find("# fails: " + judgement.signature.substr(8) + "\n"), std::string::npos);
  }
  EXPECT_GT(found, 0U);
}

TEST(EdgeClaim, MalformedFilesAreRefused) {
  const std::string square = "flatdt-instance 1 dimension 2 manifold torus points 1 0 0 ";
  for (const char* wrong :
       {"", "flatdt-edges 2\n", "flatdt-edges 1\nelements 0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1\nedges 0\n", "flatdt-edges 1\nelements 0\nedges 1\n0 0 0 0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1 0\nedges 1\n0 0 0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1 0\nedges 99999999999\n",
        "flatdt-edges 1\nsubgroup 1\n1 0 3 0 1 0\nelements 0\nedges 0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1 0\nedges 0\n0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1 0\nedges0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1 0\nxedges 0\n",
        "flatdt-edges 1\nelements 1\n1 0 0 0 1 0\nedges 0"})
    EXPECT_EQ(judge_edges(square, wrong, 0).signature, "malformed") << wrong;
}

/// Every edge of ref's triangulation as a claim without it, in all of its places.
void expect_each_edge_missed(const std::string& instance_text, std::size_t least_edges) {
  const ref::Instance instance = ref::parse_instance(instance_text, "instance");
  const auto analysis = ref::analyse(instance);
  const auto t = ref::triangulate(instance, analysis, {}).triangulation;
  const DelaunayGraph graph(instance, analysis, t);
  std::string head = "flatdt-edges 1\nelements " + std::to_string(t.elements.size()) + "\n";
  for (const ref::Isometry& g : t.elements) head += g.to_string() + "\n";
  std::map<EdgeKey, std::set<std::string>> edges;
  const auto word = [](const auto& v) { return std::to_string(v.point) + " " + std::to_string(v.element); };
  for (const auto& cell : t.cells)
    for (std::size_t a = 0; a <= static_cast<std::size_t>(t.dimension); ++a)
      for (std::size_t b = 0; b < a; ++b)
        edges[graph.key({cell[a].point, t.elements[cell[a].element]},
                        {cell[b].point, t.elements[cell[b].element]})]
            .insert(word(cell[a]) + " " + word(cell[b]) + "\n");
  EXPECT_GE(edges.size(), least_edges) << instance_text;
  EXPECT_EQ(graph.strong_edges().size(), edges.size()) << "no ties: every edge has a facet";
  for (const auto& [missing, ignored] : edges) {
    std::string text;
    std::size_t count = 0;
    for (const auto& [edge, places] : edges)
      if (edge != missing)
        for (const std::string& line : places) {
          text += line;
          ++count;
        }
    std::string claim = head;
    claim.append("edges ").append(std::to_string(count)).append("\n").append(text);
    EXPECT_EQ(judge_edges(instance_text, claim, 0).signature, "refuted edges.present") << claim;
  }
}

TEST(EdgeClaim, NoEdgeCanBeMissing) {
  // By Euler: 3 edges a point in the plane. In space a torus of one generic point has 7.
  expect_each_edge_missed(
      "flatdt-instance 1 dimension 2 manifold klein-bottle points 3 1/10 1/5 3/4 3/8 2/5 9/10 ", 9);
  expect_each_edge_missed("flatdt-instance 1 dimension 2 manifold torus metric 5 1 4 points 1 0 0 ", 3);
  expect_each_edge_missed(
      "flatdt-instance 1 dimension 3 manifold torocosm metric 10 1 2 11 3 12 points 1 0 0 0 ", 7);
  expect_each_edge_missed(
      "flatdt-instance 1 dimension 3 manifold torocosm metric 10 1 2 11 3 12 points 2 0 0 0 2/7 3/11 5/13 ",
      14);
}

}  // namespace
}  // namespace flatdt::campaign
