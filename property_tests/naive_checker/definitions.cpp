#include "naive_checker/definitions.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "oracle/orbit_points.hpp"
#include "oracle/polytope.hpp"

namespace flatdt::naive {
namespace {

using oracle::circumscribed_ball;
using oracle::composed;
using oracle::floor_of;
using oracle::identity;
using oracle::image;
using oracle::Integer;
using oracle::intersection;
using oracle::inverse;
using oracle::Matrix;
using oracle::minus;
using oracle::pairing;
using oracle::plus;
using oracle::Polytope;
using oracle::Rational;
using oracle::Seitz;
using oracle::short_basis;
using oracle::simplex_volume;
using oracle::square;
using oracle::times;
using oracle::translation_by;
using oracle::transposed;
using oracle::Vector;

/// The least and the greatest value of each coordinate.
std::pair<Vector, Vector> box_of(const std::vector<Vector>& corners, const Matrix& to_coordinates) {
  Vector low = image(to_coordinates, corners[0]);
  Vector high = low;
  for (const Vector& x : corners) {
    const Vector y = image(to_coordinates, x);
    for (std::size_t i = 0; i < y.size(); ++i) {
      low[i] = std::min(low[i], y[i]);
      high[i] = std::max(high[i], y[i]);
    }
  }
  return {low, high};
}

/// A half-space of the polytope has all points strictly on its far side.
bool are_separated(const Polytope& cell, const std::vector<Vector>& points) {
  return std::any_of(cell.half_spaces().begin(), cell.half_spaces().end(), [&](const oracle::HalfSpace& h) {
    return std::all_of(points.begin(), points.end(),
                       [&](const Vector& x) { return pairing(h.normal, x) > h.offset; });
  });
}

/// All translates of a cell by the lattice of H whose boxes meet a given box.
class Translates {
 public:
  Translates(const oracle::Group& subgroup, const Matrix& metric)
      : basis_(short_basis(subgroup.lattice, metric)), dimension_(subgroup.dimension) {
    Matrix rows;
    for (std::size_t i = 0; i < basis_.size(); ++i) rows[i] = basis_[i];
    to_coordinates_ = inverse(transposed(rows), dimension_);
  }
  [[nodiscard]] std::pair<Vector, Vector> box(const std::vector<Vector>& corners) const {
    return box_of(corners, to_coordinates_);
  }
  /// The lattice vectors v such that the box [low, high] + v meets the box [to_low, to_high].
  [[nodiscard]] std::vector<Vector> between(const std::pair<Vector, Vector>& from,
                                            const std::pair<Vector, Vector>& to) const {
    std::vector<Vector> found{Vector{}};
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      std::vector<Vector> longer;
      Integer n = -floor_of(from.second[i] - to.first[i]);  // n >= to.low - from.high
      for (; n <= to.second[i] - from.first[i]; ++n)
        for (const Vector& v : found) longer.push_back(plus(v, times(n, basis_[i])));
      found = std::move(longer);
    }
    return found;
  }

 private:
  std::vector<Vector> basis_;
  int dimension_;
  Matrix to_coordinates_;
};

std::vector<Vector> sorted(std::vector<Vector> points) {
  std::sort(points.begin(), points.end());
  return points;
}

enum class Meeting { apart, common_face, otherwise };

/// How two simplices meet. The intersection is computed, and its vertices are compared with the common
/// corners.
Meeting meeting(const Polytope& s, const std::vector<Vector>& s_corners, const std::vector<Vector>& t_corners,
                int dimension) {
  if (are_separated(s, t_corners)) return Meeting::apart;
  const Polytope common = intersection(s, Polytope::simplex(t_corners, dimension));
  if (common.vertices().empty()) return Meeting::apart;
  std::vector<Vector> vertices;
  for (const Polytope::Vertex& v : common.vertices()) vertices.push_back(v.position);
  const std::vector<Vector> a = sorted(s_corners);
  const std::vector<Vector> b = sorted(t_corners);
  std::vector<Vector> shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  const bool is_proper = shared.size() < a.size();  // otherwise one simplex is listed twice
  return sorted(vertices) == shared && is_proper ? Meeting::common_face : Meeting::otherwise;
}

}  // namespace

bool balls_are_empty(const FaceComplex& complex, const oracle::Group& group,
                     const checker::Instance& instance) {
  const oracle::OrbitPoints points(group, instance.metric, instance.points);
  return std::all_of(complex.cells.begin(), complex.cells.end(), [&](const std::vector<Vector>& cell) {
    if (simplex_volume(cell, complex.dimension) == 0) return true;
    const oracle::Ball ball = circumscribed_ball(cell, instance.metric, complex.dimension);
    const Vector nearest = points.nearest(ball.centre).front().position;
    return square(instance.metric, minus(nearest, ball.centre)) >= ball.squared_radius;
  });
}

bool has_all_vertices(const FaceComplex& complex, const oracle::Group& group,
                      const checker::Instance& instance) {
  for (const Vector& p : instance.points) {
    // Right multiplication permutes the right cosets Hg, finitely many, so inverses are not needed to reach
    // all.
    std::set<Vector> seen{complex.subgroup.canonical(p).first};
    std::vector<Seitz> open{translation_by({}, group.dimension)};
    while (!open.empty()) {
      const Seitz g = open.back();
      open.pop_back();
      if (!complex.faces[0].contains({complex.subgroup.canonical(image(g, p)).first})) return false;
      for (const Seitz& s : instance.generators) {
        const Seitz next = composed(g, s);
        const auto [place, mover] = complex.subgroup.canonical(image(next, p));
        if (seen.insert(place).second)
          open.push_back(composed(mover, next));  // of the coset, with a small translation
      }
    }
  }
  return true;
}

Intersections intersections(const FaceComplex& complex) {
  Intersections result;
  const Translates translates(complex.subgroup, identity(complex.dimension));
  for (std::size_t i = 0; i < complex.cells.size(); ++i) {
    const Polytope s = Polytope::simplex(complex.cells[i], complex.dimension);
    const auto s_box = translates.box(complex.cells[i]);
    for (std::size_t j = i; j < complex.cells.size(); ++j) {
      std::size_t met = 0;
      for (const Seitz& c : complex.subgroup.cosets) {
        std::vector<Vector> t;
        for (const Vector& x : complex.cells[j]) t.push_back(image(c, x));
        for (const Vector& v : translates.between(translates.box(t), s_box)) {
          const bool is_same = i == j && v == Vector{} && &c == &complex.subgroup.cosets.front();
          if (is_same) continue;
          std::vector<Vector> lift;
          for (const Vector& x : t) lift.push_back(plus(x, v));
          const Meeting how = meeting(s, complex.cells[i], lift, complex.dimension);
          if (how != Meeting::apart) ++met;
          if (how == Meeting::otherwise) result.face_to_face = false;
        }
      }
      if (met > (i == j ? 0U : 1U)) result.at_most_once = false;
    }
  }
  return result;
}

}  // namespace flatdt::naive
