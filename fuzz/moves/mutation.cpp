/// The choice among the moves, query points, and the crossing of two specimens.
#include <algorithm>

#include "moves.hpp"

namespace flatdt::fuzz {
namespace {

/// Bounds that a move of one part may have broken in another.
void repair(Specimen& specimen) {
  if (specimen.elements.empty()) specimen.cells.clear();
  for (CodedCell& cell : specimen.cells) {
    for (CodedVertex& vertex : cell) {
      vertex.point = static_cast<std::uint8_t>(vertex.point % specimen.points.size());
      vertex.element = static_cast<std::uint8_t>(vertex.element % specimen.elements.size());
    }
  }
  for (CodedQuery& query : specimen.queries)
    query.point = static_cast<std::uint8_t>(query.point % specimen.points.size());
}

}  // namespace

bool move_queries(Specimen& specimen, Random& random) {
  const auto anything = [&] {
    CodedQuery query;
    query.point = static_cast<std::uint8_t>(random.index(specimen.points.size()));
    query.coset = static_cast<std::uint8_t>(random.below(12));
    const int reach = random.one_in(10) ? 100 : 1;
    for (std::int8_t& s : query.shift) s = static_cast<std::int8_t>(random.below(2 * reach + 1) - reach);
    return query;
  };
  std::vector<CodedQuery>& queries = specimen.queries;
  if (queries.size() < 4 || (queries.size() < kMaxQueries && random.one_in(3))) {
    queries.push_back(anything());
  } else if (random.one_in(6)) {
    queries.erase(queries.begin() + static_cast<std::ptrdiff_t>(random.index(queries.size())));
  } else if (random.one_in(4)) {  // all by one lattice vector: the signs stay
    const CodedQuery by = anything();
    for (CodedQuery& query : queries)
      for (std::size_t i = 0; i < 3; ++i)
        query.shift[i] = static_cast<std::int8_t>((query.shift[i] + by.shift[i]) % 100);
  } else {
    queries[random.index(queries.size())] = anything();
  }
  return true;
}

bool move_anything(Specimen& specimen, Random& random, const Shape& shape) {
  const int kind = random.below(10);
  if (shape.triangulation && kind < 6) return move_cells(specimen, random);
  if (shape.queries && kind < 4) return move_queries(specimen, random);
  const bool moved = kind < 7   ? move_point(specimen, random)
                     : kind < 8 ? move_metric(specimen, random)
                                : move_group(specimen, random);
  if (!moved) return false;
  repair(specimen);
  // The triangulation of the instance as it is now: otherwise most of these would be wrong for a dull reason.
  if (shape.triangulation && random.one_in(2)) return recompute_cells(specimen, random);
  return true;
}

bool cross(Specimen& specimen, const Specimen& other, Random& random, const Shape& shape) {
  const int d = specimen.dimension();
  switch (random.below(4)) {
    case 0:
    case 1:
      for (const ref::Vector& x : other.points)
        if (specimen.points.size() < kMaxPoints && random.one_in(2))
          specimen.points.push_back(in_dimension(x, d));
      break;
    case 2:
      if (other.dimension() != d || !other.gram) return false;
      specimen.gram = other.gram;
      break;
    default: {  // the other's group with these points
      Specimen crossed = other;
      crossed.points.clear();
      for (const ref::Vector& x : specimen.points)
        crossed.points.push_back(in_dimension(x, other.dimension()));
      crossed.queries = specimen.queries;
      specimen = crossed;
      break;
    }
  }
  repair(specimen);
  if (shape.triangulation && random.one_in(2)) return recompute_cells(specimen, random);
  return true;
}

}  // namespace flatdt::fuzz
