#include "oracle/lattice.hpp"

#include <algorithm>
#include <utility>

namespace flatdt::oracle {

void Lattice::insert(Vector v) {
  for (std::size_t c = 0; c < basis_.size(); ++c) {
    if (v[c] == 0) continue;
    if (!basis_[c]) {
      basis_[c] = times(sgn(v[c]), v);
      return;
    }
    Vector& row = *basis_[c];
    // Commensurable numbers, both multiples of one unit: Euclid's algorithm ends.
    while (v[c] != 0) {
      row = minus(row, times(floor_of(row[c] / v[c]), v));
      std::swap(row, v);
    }
    if (row[c] < 0) row = times(-1, row);
  }
}

Vector Lattice::reduced(Vector v) const {
  for (std::size_t c = 0; c < basis_.size(); ++c)
    if (basis_[c]) v = minus(v, times(floor_of(v[c] / (*basis_[c])[c]), *basis_[c]));
  return v;
}

bool Lattice::contains(const Vector& v) const {
  return reduced(v) == Vector{};
}

int Lattice::rank() const {
  return static_cast<int>(
      std::count_if(basis_.begin(), basis_.end(), [](const auto& b) { return b.has_value(); }));
}

Rational Lattice::covolume(int dimension) const {
  Rational volume = 1;
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c) volume *= (*basis_[c])[c];
  return volume;
}

std::vector<Vector> Lattice::basis() const {
  std::vector<Vector> rows;
  for (const auto& row : basis_)
    if (row) rows.push_back(*row);
  return rows;
}

std::vector<Vector> short_basis(const Lattice& lattice, const Matrix& metric) {
  std::vector<Vector> basis = lattice.basis();
  bool shorter = true;
  while (shorter) {
    shorter = false;
    for (Vector& a : basis) {
      for (const Vector& b : basis) {
        if (&a == &b) continue;
        const Integer m = nearest_integer(pairing(a, image(metric, b)) / square(metric, b));
        const Vector candidate = minus(a, times(m, b));
        if (square(metric, candidate) >= square(metric, a)) continue;
        a = candidate;
        shorter = true;
      }
    }
  }
  std::sort(basis.begin(), basis.end(),
            [&](const Vector& a, const Vector& b) { return square(metric, a) < square(metric, b); });
  return basis;
}

}  // namespace flatdt::oracle
