#include "delaunay_graph.hpp"

#include <algorithm>

namespace flatdt::campaign {
namespace {

using ref::Isometry;
using ref::Matrix;
using ref::Rational;
using ref::Vector;

}  // namespace

DelaunayGraph::DelaunayGraph(const ref::Instance& instance, const ref::GroupAnalysis& analysis,
                             const ref::Triangulation& triangulation)
    : instance_(instance), analysis_(analysis), lattice_inverse_(analysis.lattice.inverse()) {
  find_representatives();
  find_balls(triangulation);
  find_strong_edges();
}

bool DelaunayGraph::is_member(const Isometry& element) const {
  return std::any_of(analysis_.cosets.begin(), analysis_.cosets.end(), [&](const Isometry& c) {
    return c.linear == element.linear &&
           (lattice_inverse_ * (element.translation - c.translation)).is_integral();
  });
}

void DelaunayGraph::find_representatives() {
  const auto element_to = [&](const Vector& from, const Vector& to) -> std::optional<Isometry> {
    for (const Isometry& c : analysis_.cosets) {
      const Vector rest = to - c * from;
      if ((lattice_inverse_ * rest).is_integral()) return Isometry::translate(rest) * c;
    }
    return std::nullopt;
  };
  for (std::uint32_t i = 0; i < instance_.points.size(); ++i) {
    representatives_.push_back({i, Isometry::identity(instance_.dimension)});
    for (std::uint32_t j = 0; j < i; ++j) {
      if (representatives_[j].point != j) continue;
      if (auto element = element_to(instance_.points[j], instance_.points[i])) {
        representatives_[i] = {j, *element};
        break;
      }
    }
  }
}

Lift DelaunayGraph::representative(const Lift& lift) const {
  const Lift& first = representatives_[lift.point];
  return {first.point, lift.element * first.element};
}

EdgeKey DelaunayGraph::key(const Lift& a, const Lift& b) const {
  const Lift from = representative(a), to = representative(b);
  const auto seen = [&](const Lift& x, const Lift& y) {
    return EdgeKey{x.point, x.element.inverse() * place(y)};
  };
  return std::min(seen(from, to), seen(to, from));
}

Vector DelaunayGraph::circumcentre(const std::vector<Vector>& vertices) const {
  // 2 (v_k - v_0)^T G (c - v_0) = |v_k - v_0|^2.
  const int d = instance_.dimension;
  Matrix rows(d);
  Vector right(d);
  for (int k = 0; k < d; ++k) {
    const Vector edge = vertices[static_cast<std::size_t>(k) + 1] - vertices[0];
    const Vector dual = instance_.gram * edge;
    for (int j = 0; j < d; ++j) rows(k, j) = Rational(2) * dual[j];
    right[k] = ref::squared_length(instance_.gram, edge);
  }
  return vertices[0] + rows.inverse() * right;
}

/// The cell moved by the group so that a corner of the least point is points[point], as what all its images
/// share.
DelaunayGraph::CellKey DelaunayGraph::cell_key(const std::vector<Lift>& lifts,
                                               const std::vector<Vector>& places) const {
  std::uint32_t least = lifts.front().point;
  for (const Lift& lift : lifts) least = std::min(least, lift.point);
  CellKey key;
  for (const Lift& corner : lifts) {
    if (corner.point != least) continue;
    const Isometry back = corner.element.inverse();
    CellKey seen;
    for (std::size_t k = 0; k < lifts.size(); ++k) seen.emplace_back(lifts[k].point, back * places[k]);
    std::sort(seen.begin(), seen.end());
    if (key.empty() || seen < key) key = std::move(seen);
  }
  return key;
}

void DelaunayGraph::find_balls(const ref::Triangulation& triangulation) {
  const auto corners = static_cast<std::size_t>(instance_.dimension) + 1;
  balls_.resize(instance_.points.size());
  std::set<CellKey> known;  // on a cover there is a cell for each sheet
  for (const auto& cell : triangulation.cells) {
    std::vector<Lift> lifts;
    std::vector<Vector> places;
    for (std::size_t k = 0; k < corners; ++k) {
      lifts.push_back(representative({cell[k].point, triangulation.elements[cell[k].element]}));
      places.push_back(place(lifts.back()));
    }
    if (!known.insert(cell_key(lifts, places)).second) continue;
    const Vector centre = circumcentre(places);
    for (const Lift& corner : lifts) {
      const Isometry back = corner.element.inverse();
      Ball ball{{}, back * centre};
      for (const Lift& x : lifts) ball.vertices.push_back({x.point, back * x.element});
      balls_[corner.point].push_back(std::move(ball));
    }
  }
}

Rational DelaunayGraph::squared_width(const std::set<Vector>& vertices) const {
  const ref::Matrix& gram = instance_.gram;
  Vector start = *vertices.begin(), axis(instance_.dimension);
  Rational longest(0);
  for (const Vector& a : vertices)
    for (const Vector& b : vertices)
      if (const Rational length = ref::squared_length(gram, b - a); length > longest) {
        longest = length;
        start = a;
        axis = b - a;
      }
  if (instance_.dimension == 2) return longest;
  Rational width(0);
  for (const Vector& c : vertices) {
    const Rational along = ref::inner_product(gram, c - start, axis);
    width = std::max(width, ref::squared_length(gram, c - start) - along * along / longest);
  }
  return width;
}

void DelaunayGraph::find_strong_edges() {
  const auto least = static_cast<std::size_t>(instance_.dimension);
  for (std::uint32_t i = 0; i < balls_.size(); ++i) {
    const Lift from{i, Isometry::identity(instance_.dimension)};
    std::map<Vector, std::pair<std::set<Vector>, Lift>>
        around;  // centres of the cells around each edge from points[i]
    for (const Ball& ball : balls_[i])
      for (const Lift& to : ball.vertices) {
        const Vector end = place(to);
        if (end != instance_.points[i])
          around.try_emplace(end, std::set<Vector>{}, to).first->second.first.insert(ball.centre);
      }
    for (const auto& [end, facet] : around) {
      const auto& [centres, to] = facet;
      const EdgeKey edge = key(from, to);
      edges_.insert(edge);
      // Fewer different centres: the facet is a point or a segment. More never lie on one line: they are the
      // vertices of a face of the Voronoi complex, which is face to face.
      if (centres.size() < least) continue;
      if (!strong_.contains(edge)) strong_.emplace(edge, squared_width(centres));
    }
  }
}

bool DelaunayGraph::may_be_edge(const EdgeKey& edge) const {
  if (edges_.contains(edge)) return true;
  const Vector& from = instance_.points[edge.first];
  const auto& around = balls_[edge.first];
  return std::any_of(around.begin(), around.end(), [&](const Ball& ball) {
    return ref::squared_length(instance_.gram, edge.second - ball.centre) ==
           ref::squared_length(instance_.gram, from - ball.centre);
  });
}

}  // namespace flatdt::campaign
