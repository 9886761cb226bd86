/// Closest and shortest lattice vectors through the obtuse superbase of the reduced basis.
/// Source: [ConwaySloane92] for the Voronoi-relevant vectors; the descent is lattice_descent's.
#include <algorithm>
#include <vector>

#include "flatdt/ref/lattice.hpp"
#include "lattice_descent.hpp"

namespace flatdt::ref {
namespace {

/// Subset sums of the superbase v_1..v_d (the columns), v_0 = -(v_1 + .. + v_d).
std::vector<Vector> relevant_vectors(const Matrix& obtuse_basis) {
  std::vector<Vector> superbase;
  Vector last(obtuse_basis.dimension());
  for (int j = 0; j < obtuse_basis.dimension(); ++j) {
    superbase.push_back(obtuse_basis.column(j));
    last = last - superbase.back();
  }
  superbase.push_back(last);
  return proper_subset_sums(superbase);
}

}  // namespace

std::vector<Vector> voronoi_vectors(const Matrix& gram) {
  return relevant_vectors(reduce_basis(gram).transform);
}

Rational shortest_squared_length(const Matrix& gram) {
  // A shortest vector v is relevant: a lattice vector as near to v/2 as 0 and v is either of them, or 2 s - v
  // would be shorter.
  const ReducedBasis reduced = reduce_basis(gram);
  Rational least = reduced.gram(0, 0);
  for (const Vector& n : relevant_vectors(Matrix::identity(gram.dimension())))
    least = std::min(least, squared_length(reduced.gram, n));
  return least;
}

std::vector<Vector> closest_vectors(const Matrix& gram, const Vector& x) {
  const int d = gram.dimension();
  const ReducedBasis reduced = reduce_basis(gram);
  const std::vector<Vector> relevant = relevant_vectors(Matrix::identity(d));
  Vector start = reduced.transform.inverse() * x;
  for (int i = 0; i < d; ++i) start[i] = start[i] - Rational(floor(start[i]));

  // All of x - s, s closest. These s are the vertices of the Delaunay polytope whose dual Voronoi face has x
  // in its relative interior; its edges are Voronoi-relevant, and its edge graph is connected. Two of the s
  // are never congruent modulo 2 (their midpoint would be closer), so there are at most 2^d.
  std::vector<Vector> differences = {descend(reduced.gram, relevant, start)};
  for (std::size_t i = 0; i < differences.size(); ++i) {
    for (const Vector& n : relevant) {
      if (!inner_product(reduced.gram, n - (differences[i] + differences[i]), n).is_zero()) continue;
      const Vector tie = differences[i] - n;
      if (std::find(differences.begin(), differences.end(), tie) == differences.end())
        differences.push_back(tie);
    }
  }
  std::vector<Vector> closest;
  for (const Vector& difference : differences) closest.push_back(x - reduced.transform * difference);
  std::sort(closest.begin(), closest.end());
  return closest;
}

}  // namespace flatdt::ref
