// The conditions topology.connected, topology.euler and topology.orientable, from the faces alone.
// Source: FORMAT.md; docs/soundness.md, section 6.
#include <utility>

#include "context.hpp"
#include "union_find.hpp"

namespace flatdt::checker {
namespace {

void check_connected(const Context& context) {
  using enum ConditionName;
  UnionFind components(context.complex.cells.size());
  for (const auto& [a, b] : context.faces.pairs) components.join(index(a.cell), index(b.cell));
  const std::size_t count = components.count();
  Witness witness = {{"components", number_text(count)}};
  if (count <= 1) {  // no two cells that are not joined; other conditions refute the empty complex
    context.holds(topology_connected, std::move(witness));
    return;
  }
  for (std::size_t c = 1; c < context.complex.cells.size(); ++c) {
    if (components.find(c) == components.find(0)) continue;
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
    const std::size_t faces = size == 1 ? context.complex.vertices.size() : context.faces.count[size];
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
  UnionFind cover(2 * context.complex.cells.size());
  for (const auto& [a, b] : context.faces.pairs) {
    const std::size_t flip = a.parity == b.parity ? 1 : 0;
    const std::size_t first = 2 * index(a.cell);
    const std::size_t second = 2 * index(b.cell);
    cover.join(first, second + flip);
    cover.join(first + 1, second + 1 - flip);
  }
  bool orientable = true;
  for (std::size_t c = 0; c < context.complex.cells.size(); ++c) {
    orientable = orientable && cover.find(2 * c) != cover.find(2 * c + 1);
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
