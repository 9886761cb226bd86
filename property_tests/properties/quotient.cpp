#include "quotient.hpp"

#include <algorithm>

#include "geometry.hpp"
#include "metrics.hpp"
#include "require.hpp"

namespace flatdt::property_tests {
using ref::Integer;

Quotient::Quotient(const Specimen& specimen)
    : cosets_(testing::cosets_of(testing::catalogue_generators(specimen))) {}

Quotient::Canonical Quotient::canonical(const Vector& x) const {
  Canonical best{Vector(x.dimension()), cosets_.front()};
  bool have = false;
  for (const Isometry& r : cosets_) {
    Vector y = r * x;
    Vector shift(x.dimension());
    for (int i = 0; i < x.dimension(); ++i) {
      shift[i] = Rational(floor(y[i]));
      y[i] -= shift[i];
    }
    if (have && !(y < best.point)) continue;
    best = {y, {r.linear, r.translation - shift}};
    have = true;
  }
  return best;
}

std::vector<CellCorners> corners_of(const ref::Instance& instance, const ref::Triangulation& triangulation,
                                    const Isometry& to_catalogue) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vector> known;
  std::vector<CellCorners> cells;
  for (const auto& cell : triangulation.cells) {
    CellCorners corners;
    for (std::size_t k = 0; k <= static_cast<std::size_t>(instance.dimension); ++k) {
      const auto [entry, is_new] =
          known.try_emplace({cell[k].point, cell[k].element}, Vector(instance.dimension));
      if (is_new)
        entry->second =
            to_catalogue * (triangulation.elements[cell[k].element] * instance.points[cell[k].point]);
      corners.push_back(entry->second);
    }
    cells.push_back(std::move(corners));
  }
  return cells;
}

Folded fold(const Quotient& quotient, const std::vector<CellCorners>& cells) {
  Folded folded;
  std::map<Vector, std::size_t> times;
  for (const CellCorners& cell : cells) {
    Vector sum = cell[0];
    for (std::size_t k = 1; k < cell.size(); ++k) sum = sum + cell[k];
    const Rational part(Integer(1), Integer(static_cast<long>(cell.size())));
    const Quotient::Canonical canonical = quotient.canonical(part * sum);
    if (++times[canonical.point] > 1) continue;
    CellCorners moved;
    for (const Vector& x : cell) moved.push_back(canonical.mover * x);
    std::sort(moved.begin(), moved.end());
    folded.cells.emplace(canonical.point, std::move(moved));
  }
  for (const auto& [barycentre, count] : times) {
    if (folded.multiplicity == 0) folded.multiplicity = count;
    folded.evenly = folded.evenly && count == folded.multiplicity;
  }
  return folded;
}

Tessellation tessellate(const Quotient& quotient, const Matrix& gram, const Folded& folded) {
  Tessellation result;
  for (const auto& [barycentre, cell] : folded.cells) {
    const std::optional<Sphere> ball = circumsphere(gram, cell);
    require(ball.has_value(), "a cell is flat");
    const Sphere& sphere = *ball;
    const Quotient::Canonical canonical = quotient.canonical(sphere.centre);
    Polytope& polytope = result[canonical.point];
    require(polytope.vertices.empty() || polytope.squared_radius == sphere.squared_radius,
            "two empty spheres have one centre");
    polytope.squared_radius = sphere.squared_radius;
    for (const Vector& x : cell) polytope.vertices.insert(canonical.mover * x);
  }
  return result;
}

bool has_ties(const Tessellation& tessellation, int dimension) {
  return std::any_of(tessellation.begin(), tessellation.end(), [&](const auto& entry) {
    return entry.second.vertices.size() > static_cast<std::size_t>(dimension) + 1;
  });
}

Rational squared_diameter(const Tessellation& tessellation) {
  Rational largest(0);
  for (const auto& [centre, polytope] : tessellation) largest = std::max(largest, polytope.squared_radius);
  return Rational(4) * largest;
}

Skeleton skeleton(const Quotient& quotient, const Folded& folded) {
  Skeleton edges;
  std::map<Vector, Quotient::Canonical> known;
  for (const auto& [barycentre, cell] : folded.cells)
    for (const Vector& tail : cell) {
      auto at = known.find(tail);
      if (at == known.end()) at = known.emplace(tail, quotient.canonical(tail)).first;
      std::set<Vector>& heads = edges[at->second.point];
      for (const Vector& head : cell)
        if (!(head == tail)) heads.insert(at->second.mover * head);
    }
  return edges;
}

bool has_loop(const Quotient& quotient, const Skeleton& edges) {
  for (const auto& [tail, heads] : edges)
    for (const Vector& head : heads)
      if (quotient.canonical(head).point == tail) return true;
  return false;
}

bool has_two_cycle(const Quotient& quotient, const Skeleton& edges) {
  for (const auto& [tail, heads] : edges) {
    std::map<Vector, std::size_t> ends;
    for (const Vector& head : heads) ++ends[quotient.canonical(head).point];
    for (const auto& [end, count] : ends)
      // A loop g is listed twice at its vertex, with heads g and g^-1: two loops are four heads.
      if (count >= (end == tail ? 3U : 2U)) return true;
  }
  return false;
}

}  // namespace flatdt::property_tests
