/// Bounded convex polytopes, cut by one half-space after another, exactly (the double description method).
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/linear.hpp"

namespace flatdt::oracle {

/// All x with normal x <= offset (pairing of a row with a column). The normal is not zero.
struct HalfSpace {
  Vector normal;
  Rational offset;
};

/// The intersection of half-spaces; may become of lower dimension, or empty.
/// Invariant: `vertices` are the vertices, each once, and `tight` of each are all half-spaces with it on the
/// border.
class Polytope {
 public:
  struct Vertex {
    Vector position;
    std::vector<std::size_t> tight;  // ascending
  };

  /// The convex hull of affinely independent points. Requires: d+1 of them.
  static Polytope simplex(const std::vector<Vector>& points, int dimension);
  /// All x with |row_i (x - centre)| <= bound_i. Requires: d independent rows, bounds > 0.
  static Polytope parallelotope(const Vector& centre, const Matrix& rows, const Vector& bounds,
                                int dimension);

  /// Keeps what lies in the half-space. Cost: quadratic in the number of vertices.
  void cut(const HalfSpace& half_space);

  [[nodiscard]] const std::vector<Vertex>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<HalfSpace>& half_spaces() const { return half_spaces_; }
  /// Some ball lies inside.
  [[nodiscard]] bool has_interior() const;

 private:
  explicit Polytope(int dimension) : dimension_(dimension) {}
  [[nodiscard]] bool are_adjacent(const Vertex& a, const Vertex& b, std::vector<std::size_t>& common) const;
  /// Rebuilds `tight` from the positions: quadratic, for the first few half-spaces.
  void add_vertex(const Vector& position);

  int dimension_;
  std::vector<HalfSpace> half_spaces_;
  std::vector<Vertex> vertices_;
};

/// The intersection of two polytopes.
[[nodiscard]] Polytope intersection(Polytope a, const Polytope& b);

}  // namespace flatdt::oracle
