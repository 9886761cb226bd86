#include "edge_claim.hpp"

#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "delaunay_graph.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"
#include "judge.hpp"

namespace flatdt::campaign {
namespace {

using ref::Rational;

struct EdgeFile {
  std::vector<ref::Isometry> elements;
  std::vector<std::pair<ref::Triangulation::CellVertex, ref::Triangulation::CellVertex>> edges;
};

std::string without_comments(const std::string& text) {
  std::string result;
  bool comment = false;
  for (const char c : text) {
    if (c == '#') comment = true;
    if (c == '\n') comment = false;
    if (!comment) result += c;
  }
  return result;
}

std::uint32_t read_index(std::istream& in, std::size_t bound) {
  std::string token;
  if (!(in >> token)) throw std::runtime_error("the file ends where an index must stand");
  if (token.size() > 9 || token.find_first_not_of("0123456789") != std::string::npos ||
      std::stoul(token) >= bound)
    throw std::runtime_error("\"" + token + "\" is no index below " + std::to_string(bound));
  return static_cast<std::uint32_t>(std::stoul(token));
}

/// Errors: std::runtime_error.
EdgeFile parse_edges(const std::string& text, int dimension, std::size_t points) {
  const std::string plain = without_comments(text);
  std::istringstream in(plain);
  std::string header, version;
  in >> header >> version;
  if (header != "flatdt-edges" || version != "1")
    throw std::runtime_error("the file must start with flatdt-edges 1");
  // A number cut short would be another number.
  if (plain.empty() || plain.back() != '\n') throw std::runtime_error("the file must end with a line break");
  // Elements are written as in a triangulation file, so the reader of those reads them.
  std::string elements, word;
  while (in >> word && word != "edges") elements += word + '\n';
  if (word != "edges") throw std::runtime_error("the file has no section \"edges\"");
  EdgeFile file;
  ref::Triangulation head = ref::parse_triangulation("flatdt-triangulation 1\n" + elements + "\ncells 0\n",
                                                     "output", dimension, points);
  if (head.has_subgroup) throw std::runtime_error("a file of edges has no section \"subgroup\"");
  file.elements = std::move(head.elements);
  const std::uint32_t count = read_index(in, 1'000'000'000);
  for (std::uint32_t i = 0; i < count; ++i) {
    ref::Triangulation::CellVertex ends[2];
    for (auto& end : ends) {
      end.point = read_index(in, points);
      end.element = read_index(in, file.elements.size());
    }
    file.edges.emplace_back(ends[0], ends[1]);
  }
  if (in >> word) throw std::runtime_error("\"" + word + "\" stands after the last edge");
  return file;
}

std::string text_of(const EdgeKey& edge, const ref::Instance& instance) {
  std::string from = instance.points[edge.first].to_string(), to = edge.second.to_string();
  for (std::string* s : {&from, &to})
    for (char& c : *s)
      if (c == ' ') c = ',';
  return "(" + from + ");(" + to + ")";
}

class EdgeVerdict {
 public:
  void fail(const std::string& condition, const std::string& key, const std::string& value) {
    if (!failing_.contains(condition)) failing_[condition] = {key, value};
  }
  [[nodiscard]] Judgement judgement() const {
    Judgement result;
    nlohmann::ordered_json conditions = nlohmann::ordered_json::array();
    for (const char* name : {"edges.member", "edges.delaunay", "edges.present"}) {
      const auto at = failing_.find(name);
      const bool fails = at != failing_.end();
      nlohmann::ordered_json witness = nlohmann::ordered_json::object();
      if (fails) witness[at->second.first] = at->second.second;
      conditions.push_back({{"name", name}, {"status", fails ? "fails" : "holds"}, {"witness", witness}});
      if (fails) result.signature += std::string(result.signature.empty() ? "refuted " : " ") + name;
      if (fails) result.reason += std::string(name) + ": " + at->second.second + "\n";
    }
    result.worth = failing_.empty() ? Worth::right : Worth::wrong;
    result.verdict = nlohmann::ordered_json{{"schema", "flatdt-edges-verdict 1"},
                                            {"verdict", failing_.empty() ? "VERIFIED" : "REFUTED"},
                                            {"conditions", conditions}}
                         .dump(1) +
                     '\n';
    return result;
  }

 private:
  std::map<std::string, std::pair<std::string, std::string>> failing_;
};

Judgement compare(const DelaunayGraph& graph, const EdgeFile& file, const ref::Instance& instance,
                  const Rational& least_squared_width) {
  EdgeVerdict verdict;
  for (const ref::Isometry& element : file.elements)
    if (!graph.is_member(element)) {
      verdict.fail("edges.member", "element", element.to_string());
      return verdict.judgement();
    }
  std::set<EdgeKey> claimed;
  for (const auto& [a, b] : file.edges) {
    const Lift from{a.point, file.elements[a.element]}, to{b.point, file.elements[b.element]};
    const EdgeKey edge = graph.key(from, to);
    claimed.insert(edge);
    if (edge.second == instance.points[edge.first] || !graph.may_be_edge(edge))
      verdict.fail("edges.delaunay", "edge", text_of(edge, instance));
  }
  for (const auto& [edge, width] : graph.strong_edges()) {
    if (width <= least_squared_width || claimed.contains(edge)) continue;
    verdict.fail("edges.present", "edge",
                 text_of(edge, instance) + " squared-facet-width=" +
                     std::to_string(width.numerator().to_double() / width.denominator().to_double()));
  }
  return verdict.judgement();
}

}  // namespace

Judgement judge_edges(const std::string& instance_text, const std::string& output,
                      const Rational& facet_resolution) {
  const ref::Instance instance = ref::parse_instance(instance_text, "instance");
  EdgeFile file;
  try {
    file = parse_edges(output, instance.dimension, instance.points.size());
  } catch (const std::runtime_error& error) {
    return {Worth::wrong, "malformed", {}, error.what()};
  }
  const ref::GroupAnalysis analysis = ref::analyse(instance);
  const ref::TriangulationResult truth = ref::triangulate(instance, analysis, {});
  // In units of the shortest translation, squared.
  const Rational least = facet_resolution * facet_resolution * analysis.frame.gram(0, 0);
  return compare(DelaunayGraph(instance, analysis, truth.triangulation), file, instance, least);
}

}  // namespace flatdt::campaign
