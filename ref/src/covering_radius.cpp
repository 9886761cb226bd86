/// The covering radius of a lattice from the Delaunay simplices of its obtuse superbase.
/// Source: [Voronoi1908] (first perfect form); [ConwaySloane92].
#include <algorithm>
#include <array>

#include "flatdt/ref/lattice.hpp"

namespace flatdt::ref {
namespace {

/// Squared circumradius of the simplex 0, w_1, .., w_d with the w_i as columns: its centre c has
/// 2 <c,w_i> = <w_i,w_i>, so |c|^2 = diag^T H^-1 diag / 4 for H = (<w_i,w_j>).
Rational circumradius_squared(const Matrix& gram, const Matrix& simplex) {
  const Matrix products = simplex.transpose() * gram * simplex;
  Vector diagonal(gram.dimension());
  for (int i = 0; i < gram.dimension(); ++i) diagonal[i] = products(i, i);
  return squared_length(products.inverse(), diagonal) / Rational(4);
}

}  // namespace

Rational covering_radius_squared(const Matrix& gram) {
  // For an obtuse superbase v_0..v_d the simplices 0, v_p(1), v_p(1)+v_p(2), .., v_p(1)+..+v_p(d), p a
  // permutation of 0..d, are Delaunay simplices, and their translates tile space: if all products <v_i,v_j>,
  // i != j, are negative this is the Delaunay tessellation of Voronoi's principal domain. If some are 0, it
  // is a limit of such tessellations: the balls are still empty and, as v_p(1)..v_p(d) is a basis, no simplex
  // is flat. Rotating p translates the simplex, so p may fix v_0 in the last place: d! simplices.
  const int d = gram.dimension();
  const Matrix reduced = reduce_basis(gram).gram;
  std::array<int, kMaxDimension> order = {0, 1, 2};
  Rational largest;
  do {
    Matrix simplex(d);
    Vector vertex(d);
    for (int j = 0; j < d; ++j) {
      vertex[order[static_cast<std::size_t>(j)]] += 1;
      simplex.set_column(j, vertex);
    }
    largest = std::max(largest, circumradius_squared(reduced, simplex));
  } while (std::next_permutation(order.begin(), order.begin() + d));
  return largest;
}

}  // namespace flatdt::ref
