#include "complex.hpp"

#include <unordered_map>

namespace flatdt::checker {
namespace {

using Memo = std::unordered_map<std::uint64_t, CosetPosition, MixHash>;

/// The position of elements[k] * frame, which takes a canonical point to the vertex, remembered for each (k,
/// frame).
CosetPosition locate(Memo& memo, ElementId element, ElementId frame, const Subgroup& subgroup,
                     ElementTable& table) {
  const std::uint64_t key = pair_key(element, frame);
  if (const auto known = memo.find(key); known != memo.end()) return known->second;
  const CosetPosition position = subgroup.locate(table, table.product(element, frame));
  memo.emplace(key, position);
  return position;
}

}  // namespace

Complex make_complex(const Triangulation& triangulation, const std::vector<ElementId>& elements,
                     const Orbits& orbits, const Subgroup& subgroup, ElementTable& table) {
  Complex complex;
  complex.corners = static_cast<std::size_t>(triangulation.dimension) + 1;
  complex.cells.reserve(triangulation.cells.size());
  Memo memo;
  std::unordered_map<std::uint64_t, VertexId, MixHash> ids;
  for (const FileCell& file_cell : triangulation.cells) {
    Cell& cell = complex.cells.emplace_back();
    std::array<ElementId, 4> h{};
    for (std::size_t i = 0; i < complex.corners; ++i) {
      const std::size_t point = file_cell[i].point;
      const CosetPosition position =
          locate(memo, elements[file_cell[i].element], orbits.frame[point], subgroup, table);
      h[i] = position.transport;
      const OrbitId orbit = orbits.of_point[point];
      const auto [known, inserted] = ids.try_emplace(pair_key(orbit, position.representative),
                                                     make_id<VertexId>(complex.vertices.size()));
      if (inserted) complex.vertices.push_back({orbit, position.representative});
      cell.vertex[i] = known->second;
    }
    cell.anchor = h[0];
    for (std::size_t j = 0; j < complex.corners; ++j) cell.offset[0][j] = table.left_quotient(h[0], h[j]);
    for (std::size_t i = 1; i < complex.corners; ++i) {
      for (std::size_t j = 0; j < complex.corners; ++j) {
        cell.offset[i][j] = table.left_quotient(cell.offset[0][i], cell.offset[0][j]);
      }
    }
  }
  return complex;
}

}  // namespace flatdt::checker
