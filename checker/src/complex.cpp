#include "complex.hpp"

#include "id_map.hpp"

namespace flatdt::checker {
namespace {

/// The positions of elements[k] * frame, which takes a canonical point to the vertex, each computed once.
class Positions {
 public:
  Positions(const Subgroup& subgroup, ElementTable& table) : subgroup_(subgroup), table_(table) {}

  const CosetPosition& locate(ElementId element, ElementId frame) {
    const std::uint64_t key = pair_key(element, frame);
    if (!positions_.empty() && key == last_key_) return positions_[last_];
    const auto next = static_cast<std::uint32_t>(positions_.size());
    last_ = numbers_.insert(key, next);
    last_key_ = key;
    if (last_ == next) positions_.push_back(subgroup_.locate(table_, table_.product(element, frame)));
    return positions_[last_];
  }

 private:
  const Subgroup& subgroup_;
  ElementTable& table_;
  IdMap numbers_;
  std::vector<CosetPosition> positions_;
  std::uint64_t last_key_ = 0;
  std::uint32_t last_ = 0;
};

/// Numbers the vertices modulo H: pairs of an orbit and a right coset.
class Vertices {
 public:
  Vertices(std::size_t orbits, std::vector<Vertex>& vertices)
      : vertices_(vertices), first_(orbits, kUnseen) {}

  VertexId number(OrbitId orbit, ElementId coset) {
    const auto next = static_cast<std::uint32_t>(vertices_.size());
    std::uint32_t& first = first_[index(orbit)];
    std::uint32_t number = next;
    if (first == kUnseen) {
      first = next;
    } else if (vertices_[first].coset == coset) {
      number = first;
    } else {
      number = others_.insert(pair_key(orbit, coset), next);
    }
    if (number == next) vertices_.push_back({orbit, coset});
    return make_id<VertexId>(number);
  }

 private:
  static constexpr std::uint32_t kUnseen = 0xFFFFFFFF;

  std::vector<Vertex>& vertices_;
  std::vector<std::uint32_t> first_;  // by OrbitId: its first vertex
  IdMap others_;
};

/// The shapes, by the offsets of the vertices 1, 2, 3 in the frame of vertex 0.
class Shapes {
 public:
  Shapes(ElementTable& table, Complex& complex)
      : table_(table),
        shapes_(complex.shapes),
        reversing_(complex.reversing),
        has_reversing_(complex.has_reversing) {}

  std::uint32_t number(const std::array<ElementId, 4>& first, std::size_t corners) {
    if (!shapes_.empty() && first == shapes_.front()[0]) return 0;
    const auto next_pair = static_cast<std::uint32_t>(pair_count_);
    const std::uint32_t pair = pairs_.insert(pair_key(first[1], first[2]), next_pair);
    if (pair == next_pair) ++pair_count_;
    const auto next = static_cast<std::uint32_t>(shapes_.size());
    const std::uint32_t number = triples_.insert(pair_key(pair, first[3]), next);
    if (number == next) add(first, corners);
    return number;
  }

 private:
  void add(const std::array<ElementId, 4>& first, std::size_t corners) {
    Offsets& offset = shapes_.emplace_back();
    offset[0] = first;
    for (std::size_t i = 1; i < corners; ++i) {
      for (std::size_t j = 0; j < corners; ++j) {
        offset[i][j] = table_.left_quotient(offset[0][i], offset[0][j]);
      }
    }
    unsigned reversing = 0;
    for (std::size_t j = 0; j < corners; ++j) {
      if (table_.group().reversing[table_[first[j]].rotation]) reversing |= 1U << j;
    }
    reversing_.push_back(static_cast<std::uint8_t>(reversing));
    has_reversing_ = has_reversing_ || reversing != 0;
  }

  ElementTable& table_;
  std::vector<Offsets>& shapes_;
  std::vector<std::uint8_t>& reversing_;
  bool& has_reversing_;
  IdMap pairs_;
  IdMap triples_;
  std::size_t pair_count_ = 0;
};

}  // namespace

Complex make_complex(const Triangulation& triangulation, const std::vector<ElementId>& elements,
                     const Orbits& orbits, const Subgroup& subgroup, ElementTable& table) {
  Complex complex;
  complex.corners = static_cast<std::size_t>(triangulation.dimension) + 1;
  complex.cells.reserve(triangulation.cells.size());
  Positions positions(subgroup, table);
  Shapes shapes(table, complex);
  shapes.number({}, complex.corners);
  Vertices vertices(orbits.count(), complex.vertices);
  for (const FileCell& file_cell : triangulation.cells) {
    Cell& cell = complex.cells.emplace_back();
    std::array<ElementId, 4> offset{};
    for (std::size_t i = 0; i < complex.corners; ++i) {
      const std::size_t point = file_cell[i].point;
      const CosetPosition& position = positions.locate(elements[file_cell[i].element], orbits.frame[point]);
      const OrbitId orbit = orbits.of_point[point];
      cell.vertex[i] = vertices.number(orbit, position.representative);
      offset[i] = position.transport;
    }
    cell.anchor = offset[0];
    for (std::size_t j = 0; j < complex.corners; ++j) offset[j] = table.left_quotient(cell.anchor, offset[j]);
    cell.shape = shapes.number(offset, complex.corners);
  }
  return complex;
}

}  // namespace flatdt::checker
