// The conditions topology.connected, topology.euler and topology.orientable, from the faces alone.
// Source: FORMAT.md; docs/soundness.md, section 6.
#include <algorithm>
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

/// The components of the cells, each cell with an orientation relative to the least cell of its component: a
/// union-find structure with signs, over the pairs in the order in which the stars were met. Going from
/// neighbour to neighbour jumps through the cells: twice the time.
/// Law: orientations of neighbours agree iff the orders (facet's list, apex) that they give the facet have
/// different signs. The complex is orientable iff no pair disagrees with what earlier pairs imply.
class OrientedComponents {
 public:
  std::size_t components = 0;
  std::size_t second_component = 0;  ///< its least cell
  bool orientable = true;

  explicit OrientedComponents(const Context& context)
      : components(context.complex.cells.size()), towards_(components) {
    for (std::size_t c = 0; c < towards_.size(); ++c) towards_[c] = 2 * static_cast<std::uint32_t>(c);
    for (const auto& [a, b] : context.faces.pairs) {
      const std::uint32_t turns = a.parity == b.parity ? 1 : 0;
      join(root(static_cast<std::uint32_t>(a.cell)), root(static_cast<std::uint32_t>(b.cell)), turns);
    }
    if (components < 2) return;
    for (second_component = 1; towards_[second_component] >> 1U != second_component;) ++second_component;
  }

 private:
  /// Twice the least cell known of the component, plus one if c is turned over against it.
  std::uint32_t root(std::uint32_t c) {
    std::uint32_t turned = 0;
    while (towards_[c] >> 1U != c) {
      // The path is halved: a parent's parent becomes the parent.
      towards_[c] = towards_[towards_[c] >> 1U] ^ (towards_[c] & 1U);
      turned ^= towards_[c] & 1U;
      c = towards_[c] >> 1U;
    }
    return 2 * c + turned;
  }

  void join(std::uint32_t a, std::uint32_t b, std::uint32_t turns) {
    const std::uint32_t sign = (a ^ b ^ turns) & 1U;
    if (a >> 1U == b >> 1U) {
      orientable = orientable && sign == 0;
      return;
    }
    towards_[std::max(a, b) >> 1U] = (std::min(a, b) & ~1U) | sign;
    --components;
  }

  std::vector<std::uint32_t> towards_;  // twice a lesser cell or itself, plus one if turned over against it
};

void check_connected(const Context& context, const OrientedComponents& cells) {
  using enum ConditionName;
  Witness witness = {{"components", number_text(cells.components)}};
  if (cells.components <= 1) {  // other conditions refute the empty complex
    context.holds(topology_connected, std::move(witness));
  } else {
    witness.emplace_back("cells", "0," + number_text(cells.second_component));
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
  const OrientedComponents cells(context);
  check_connected(context, cells);
  check_euler(context);
  check_orientable(context, cells.orientable);
}

}  // namespace flatdt::checker
