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

namespace {

/// Makes `a` the candidate if that is shorter.
bool shorten(Vector& a, const Vector& candidate, const Matrix& metric) {
  if (square(metric, candidate) >= square(metric, a)) return false;
  a = candidate;
  return true;
}

/// Makes basis[i] shorter by multiples of one other vector, or by a sum of the two others, if it can.
bool shorten(std::vector<Vector>& basis, std::size_t i, const Matrix& metric) {
  bool shorter = false;
  Vector& a = basis[i];
  for (std::size_t k = 0; k < basis.size(); ++k) {
    if (k == i) continue;
    const Vector& b = basis[k];
    const Integer m = nearest_integer(pairing(a, image(metric, b)) / square(metric, b));
    shorter = shorten(a, minus(a, times(m, b)), metric) || shorter;
  }
  if (basis.size() < 3) return shorter;
  const Vector& b = basis[(i + 1) % 3];
  const Vector& c = basis[(i + 2) % 3];
  for (const int s : {-1, 1}) {
    for (const int t : {-1, 1})
      shorter = shorten(a, plus(a, plus(times(s, b), times(t, c))), metric) || shorter;
  }
  return shorter;
}

}  // namespace

std::vector<Vector> short_basis(const Lattice& lattice, const Matrix& metric) {
  std::vector<Vector> basis = lattice.basis();
  bool shorter = true;
  while (shorter) {
    shorter = false;
    for (std::size_t i = 0; i < basis.size(); ++i) shorter = shorten(basis, i, metric) || shorter;
  }
  std::sort(basis.begin(), basis.end(),
            [&](const Vector& a, const Vector& b) { return square(metric, a) < square(metric, b); });
  return basis;
}

}  // namespace flatdt::oracle
