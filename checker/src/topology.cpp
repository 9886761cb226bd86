// The conditions topology.connected, topology.euler and topology.orientable, from the faces alone.
// Source: FORMAT.md; docs/soundness.md, section 6.
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/connected_components.hpp>
#include <utility>

#include "context.hpp"

namespace flatdt::checker {
namespace {

// Directed, with every edge in both directions: the compressed graph exists in no undirected form.
using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                 boost::no_property, std::uint32_t, std::size_t>;
using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The component of every vertex of a graph, and their number.
std::size_t components(const Edges& edges, std::size_t vertices, std::vector<std::uint32_t>& component) {
  Edges both;
  both.reserve(2 * edges.size());
  for (const auto& [a, b] : edges) {
    both.emplace_back(a, b);
    both.emplace_back(b, a);
  }
  const Graph graph(boost::edges_are_unsorted_multi_pass, both.begin(), both.end(),
                    static_cast<std::uint32_t>(vertices));
  component.assign(vertices, 0);
  return boost::connected_components(
      graph, boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph)));
}

void check_connected(const Context& context) {
  using enum ConditionName;
  Edges edges;
  for (const FacetPair& pair : context.pairs) {
    edges.emplace_back(index(context.occurrences[pair.first].cell),
                       index(context.occurrences[pair.second].cell));
  }
  std::vector<std::uint32_t> component;
  const std::size_t count = components(edges, context.complex.cells.size(), component);
  Witness witness = {{"components", number_text(count)}};
  if (count <= 1) {  // no two cells that are not joined; other conditions refute the empty complex
    context.holds(topology_connected, std::move(witness));
    return;
  }
  for (std::size_t c = 0; c < component.size(); ++c) {
    if (component[c] == component[0]) continue;
    witness.emplace_back("cells", "0," + number_text(c));
    break;
  }
  context.fails(topology_connected, std::move(witness));
}

void check_euler(const Context& context) {
  using enum ConditionName;
  const std::size_t corners = context.complex.corners;
  long euler = 0;
  std::string counts;
  for (std::size_t size = 1; size <= corners; ++size) {
    const std::size_t faces = size == 1 ? context.complex.vertices.size() : context.faces[size].size();
    euler += size % 2 == 1 ? static_cast<long>(faces) : -static_cast<long>(faces);
    counts += (size == 1 ? "" : ",") + number_text(faces);
  }
  Witness witness = {{"faces-by-dimension", counts}, {"euler-number", std::to_string(euler)}};
  if (euler == 0) {
    context.holds(topology_euler, std::move(witness));
  } else {
    context.fails(topology_euler, std::move(witness));
  }
}

// The orientation cover has vertices (cell, +) = 2c and (cell, -) = 2c+1. Orientations of two cells agree
// across a facet iff the orders (facet's list, apex) that they give it have different signs. The complex is
// orientable iff no path leads from (c, +) to (c, -).
void check_orientable(const Context& context) {
  using enum ConditionName;
  Edges edges;
  for (const FacetPair& pair : context.pairs) {
    const Occurrence& a = context.occurrences[pair.first];
    const Occurrence& b = context.occurrences[pair.second];
    const std::uint32_t flip = a.parity == b.parity ? 1 : 0;
    const auto first = static_cast<std::uint32_t>(2 * index(a.cell));
    const auto second = static_cast<std::uint32_t>(2 * index(b.cell));
    edges.emplace_back(first, second + flip);
    edges.emplace_back(first + 1, second + 1 - flip);
  }
  std::vector<std::uint32_t> component;
  components(edges, 2 * context.complex.cells.size(), component);
  bool orientable = true;
  for (std::size_t c = 0; c < context.complex.cells.size(); ++c) {
    orientable = orientable && component[2 * c] != component[2 * c + 1];
  }
  const bool expected = is_orientable(context.subgroup.own());
  Witness witness = {{"complex", orientable ? "orientable" : "not-orientable"},
                     {"manifold", expected ? "orientable" : "not-orientable"}};
  if (orientable == expected) {
    context.holds(topology_orientable, std::move(witness));
  } else {
    context.fails(topology_orientable, std::move(witness));
  }
}

}  // namespace

void check_topology(const Context& context) {
  if (!context.has(ConditionName::facets_paired)) return;
  check_connected(context);
  check_euler(context);
  check_orientable(context);
}

}  // namespace flatdt::checker
