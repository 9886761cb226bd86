/// Finitely generated groups of rational vectors, as an echelon basis made by Euclid's algorithm on the
/// entries.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracle/linear.hpp"

namespace flatdt::oracle {

/// All integer combinations of the inserted vectors.
/// Invariant: basis_[c], if there, is zero before column c and positive in column c. So a vector of the
/// lattice is
///            made of at most one multiple of each, found from the first column on.
class Lattice {
 public:
  /// Adds a generator. Cost: as many subtractions as Euclid's algorithm takes on the entries.
  void insert(Vector v);
  [[nodiscard]] bool contains(const Vector& v) const;
  [[nodiscard]] int rank() const;
  /// v less the element of the lattice that leaves every pivot's column in [0, pivot): the same for all of v
  /// + L.
  [[nodiscard]] Vector reduced(Vector v) const;
  /// |det| of the basis in coordinates. Requires: rank() == dimension.
  [[nodiscard]] Rational covolume(int dimension) const;
  [[nodiscard]] std::vector<Vector> basis() const;

 private:
  std::array<std::optional<Vector>, 3> basis_;
};

/// A basis in which no vector becomes shorter by a multiple of another, or by the two others with any signs,
/// the shortest first. By multiples alone, a vector may be missed that is shorter by any factor.
/// Termination: each step shortens a vector of a discrete set. Only speed depends on the basis being short.
[[nodiscard]] std::vector<Vector> short_basis(const Lattice& lattice, const Matrix& metric);

}  // namespace flatdt::oracle
