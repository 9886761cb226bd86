// The conditions topology.connected, topology.euler and topology.orientable, from the faces alone.
// Source: FORMAT.md; docs/soundness.md, section 6.
#include <cstdint>
#include <utility>
#include <vector>

#include "context.hpp"

namespace flatdt::checker {
namespace {

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

/// What is across the facets of all cells, in the order of the corners opposite: twice a cell, plus one if
/// orders of the two cells' corners that agree across the facet (facet's list, apex) have the same sign.
std::vector<std::uint32_t> neighbours(const Context& context) {
  std::vector<std::uint32_t> across(context.complex.corners * context.complex.cells.size());
  for (const auto& [a, b] : context.faces.pairs) {
    const std::uint32_t turns = a.parity == b.parity ? 1 : 0;
    across[context.complex.corners * index(a.cell) + a.facet] =
        2 * static_cast<std::uint32_t>(b.cell) + turns;
    across[context.complex.corners * index(b.cell) + b.facet] =
        2 * static_cast<std::uint32_t>(a.cell) + turns;
  }
  return across;
}

/// Goes through the cells from neighbour to neighbour and gives each an orientation.
/// Law: orientations of neighbours agree iff the orders (facet's list, apex) that they give the facet have
/// different signs. The complex is orientable iff no two neighbours disagree in the end: along the paths
/// taken there was no choice.
struct Traversal {
  std::size_t components = 0;
  std::size_t second_component = 0;  ///< its least cell
  bool orientable = true;

  explicit Traversal(const Context& context) {
    const std::vector<std::uint32_t> across = neighbours(context);
    const std::size_t corners = context.complex.corners;
    constexpr std::uint8_t kUnseen = 2;
    std::vector<std::uint8_t> orientation(context.complex.cells.size(), kUnseen);
    std::vector<std::size_t> stack;
    for (std::size_t root = 0; root < orientation.size(); ++root) {
      if (orientation[root] != kUnseen) continue;
      if (++components == 2) second_component = root;
      orientation[root] = 0;
      for (stack.push_back(root); !stack.empty();) {
        const std::size_t c = stack.back();
        stack.pop_back();
        for (std::size_t i = 0; i < corners; ++i) {
          const std::uint32_t next = across[corners * c + i];
          const auto given = static_cast<std::uint8_t>(orientation[c] ^ (next & 1U));
          std::uint8_t& other = orientation[next >> 1];
          if (other == kUnseen) {
            other = given;
            stack.push_back(next >> 1);
          }
          orientable = orientable && other == given;
        }
      }
    }
  }
};

void check_connected(const Context& context, const Traversal& traversal) {
  using enum ConditionName;
  Witness witness = {{"components", number_text(traversal.components)}};
  if (traversal.components <= 1) {  // other conditions refute the empty complex
    context.holds(topology_connected, std::move(witness));
  } else {
    witness.emplace_back("cells", "0," + number_text(traversal.second_component));
    context.fails(topology_connected, std::move(witness));
  }
}

void check_orientable(const Context& context, bool orientable) {
  using enum ConditionName;
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
  const Traversal traversal(context);
  check_connected(context, traversal);
  check_euler(context);
  check_orientable(context, traversal.orientable);
}

}  // namespace flatdt::checker
