#include "oracle/polytope.hpp"

#include <algorithm>
#include <iterator>

namespace flatdt::oracle {

void Polytope::add_vertex(const Vector& position) {
  Vertex v{position, {}};
  for (std::size_t k = 0; k < half_spaces_.size(); ++k)
    if (pairing(half_spaces_[k].normal, position) == half_spaces_[k].offset) v.tight.push_back(k);
  vertices_.push_back(std::move(v));
}

Polytope Polytope::simplex(const std::vector<Vector>& points, int dimension) {
  Polytope result(dimension);
  // x = p_0 + sum of lambda_i (p_i - p_0): row i of the inverse gives lambda_i; all are >= 0, their sum <= 1.
  const Matrix lambda = inverse(transposed(edges_from_first(points)), dimension);
  Vector sum{};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vector normal = times(-1, lambda[i]);
    result.half_spaces_.push_back({normal, pairing(normal, points[0])});
    sum = plus(sum, lambda[i]);
  }
  result.half_spaces_.push_back({sum, pairing(sum, points[0]) + 1});
  for (const Vector& p : points) result.add_vertex(p);
  return result;
}

Polytope Polytope::parallelotope(const Vector& centre, const Matrix& rows, const Vector& bounds,
                                 int dimension) {
  Polytope result(dimension);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < d; ++i) {
    const Rational middle = pairing(rows[i], centre);
    result.half_spaces_.push_back({rows[i], middle + bounds[i]});
    result.half_spaces_.push_back({times(-1, rows[i]), bounds[i] - middle});
  }
  const Matrix back = inverse(rows, dimension);
  for (std::size_t signs = 0; signs < std::size_t{1} << d; ++signs) {
    Vector corner{};
    for (std::size_t i = 0; i < d; ++i) corner[i] = (signs >> i & 1U) != 0 ? bounds[i] : Rational(-bounds[i]);
    result.add_vertex(plus(centre, image(back, corner)));
  }
  return result;
}

/// The smallest face that holds both a and b is where their common half-spaces are tight. It is an edge iff
/// their normals have rank d-1; since a != b the rank is not d, so it is enough to find d-1 independent ones.
bool Polytope::are_adjacent(const Vertex& a, const Vertex& b, std::vector<std::size_t>& common) const {
  common.clear();
  std::set_intersection(a.tight.begin(), a.tight.end(), b.tight.begin(), b.tight.end(),
                        std::back_inserter(common));
  if (common.empty()) return false;
  if (dimension_ == 2) return true;
  return std::any_of(common.begin(), common.end(), [&](std::size_t k) {
    return cross(half_spaces_[common.front()].normal, half_spaces_[k].normal) != Vector{};
  });
}

void Polytope::cut(const HalfSpace& half_space) {
  const std::size_t added = half_spaces_.size();
  half_spaces_.push_back(half_space);
  std::vector<Vertex> kept;
  std::vector<std::pair<Vertex, Rational>> inside;
  std::vector<std::pair<Vertex, Rational>> outside;
  for (Vertex& v : vertices_) {
    const Rational excess = pairing(half_space.normal, v.position) - half_space.offset;
    if (excess == 0) v.tight.push_back(added);
    if (excess <= 0) kept.push_back(v);
    if (excess < 0) inside.emplace_back(v, excess);
    if (excess > 0) outside.emplace_back(std::move(v), excess);
  }
  std::vector<std::size_t> common;
  for (const auto& [a, below] : inside) {
    for (const auto& [b, above] : outside) {
      if (!are_adjacent(a, b, common)) continue;
      const Rational part = below / (below - above);
      common.push_back(added);
      kept.push_back({plus(a.position, times(part, minus(b.position, a.position))), common});
    }
  }
  vertices_ = std::move(kept);
}

bool Polytope::has_interior() const {
  // Of full dimension iff the vertices span: no half-space's border holds all of them, and there is a vertex.
  if (vertices_.empty()) return false;
  std::vector<std::size_t> common = vertices_.front().tight;
  for (const Vertex& v : vertices_) {
    std::vector<std::size_t> both;
    std::set_intersection(common.begin(), common.end(), v.tight.begin(), v.tight.end(),
                          std::back_inserter(both));
    common = std::move(both);
  }
  return common.empty();
}

Polytope intersection(Polytope a, const Polytope& b) {
  for (const HalfSpace& h : b.half_spaces()) {
    if (a.vertices().empty()) break;
    a.cut(h);
  }
  return a;
}

}  // namespace flatdt::oracle
