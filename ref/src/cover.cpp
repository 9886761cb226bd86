/// The three covers: Theorem 10's, the smallest for single copies, the smallest for complete orbits.
#include "flatdt/ref/cover.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "cover_search.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"
#include "lattice_root.hpp"
#include "small_closest_vectors.hpp"

namespace flatdt::ref {
namespace {

long holonomy_order(const Frame& frame) {
  return static_cast<long>(frame.cosets.size());
}

/// (4 mu)^2.
Rational single_copy_bound(const Matrix& gram) {
  return Rational(16) * covering_radius_squared(gram);
}

[[noreturn]] void throw_too_many(const std::string& relation, const Integer& sheets, long max_sheets) {
  // The number of a hostile metric may have thousands of digits.
  const std::string digits = sheets.to_string();
  throw LimitReached(
      "a covering space that is safe for copies inserted one at a time has " +
      (digits.size() > 18 ? "more than 10^" + std::to_string(digits.size() - 1) : relation + digits) +
      " sheets; the limit is " + std::to_string(max_sheets));
}

/// <c_1 e_1, .., c_d e_d>. A lattice of known safety and invariance, small or not.
struct DiagonalLattice {
  std::vector<Integer> factors;
  [[nodiscard]] Integer index() const {
    Integer product = 1;
    for (const Integer& factor : factors) product *= factor;
    return product;
  }
};

Sublattice to_sublattice(const DiagonalLattice& lattice, const Frame& frame, long max_sheets) {
  const Integer sheets = lattice.index() * Integer(holonomy_order(frame));
  if (sheets > Integer(max_sheets)) throw_too_many("", sheets, max_sheets);
  Sublattice result{Matrix(frame.dimension), lattice.index().to_long(), sheets.to_long()};
  for (int i = 0; i < frame.dimension; ++i) result.basis(i, i) = lattice.factors[static_cast<std::size_t>(i)];
  return result;
}

DiagonalLattice theorem10_lattice(const Frame& frame) {
  const Integer c = floor_sqrt(single_copy_bound(frame.gram) / shortest_squared_length(frame.gram)) + 1;
  return {std::vector<Integer>(static_cast<std::size_t>(frame.dimension), c)};
}

/// Safe: g = sum k_i c_i e_i with k_i != 0 has height |k_i| c_i / |e_i*| > 4 mu over the other basis vectors.
/// Invariant: R e_j has components only in the block of j, where all factors are the same.
DiagonalLattice product_lattice(const Frame& frame) {
  const Rational bound = single_copy_bound(frame.gram);
  const Matrix dual = frame.gram.inverse();
  DiagonalLattice lattice;
  for (int i = 0; i < frame.dimension; ++i) lattice.factors.push_back(floor_sqrt(bound * dual(i, i)) + 1);
  // Maximum over blocks: a factor travels at most d - 1 links.
  for (int round = 1; round < frame.dimension; ++round) {
    for (const Isometry& coset : frame.cosets) {
      for (int i = 0; i < frame.dimension; ++i) {
        for (int j = 0; j < frame.dimension; ++j) {
          if (coset.linear(i, j).is_zero()) continue;
          Integer &ci = lattice.factors[static_cast<std::size_t>(i)],
                  &cj = lattice.factors[static_cast<std::size_t>(j)];
          ci = cj = std::max(ci, cj);
        }
      }
    }
  }
  return lattice;
}

/// Every sublattice without a nonzero vector of squared length <= bound has at least this index n:
/// bound^d < shortest^(2d) <= gamma^d n^2 det(gram), gamma_2^2 = 4/3, gamma_3^3 = 2 (Hermite's constants).
Integer hermite_lower_bound(const Matrix& gram, const Rational& bound) {
  const bool plane = gram.dimension() == 2;
  const Rational power = plane ? bound * bound : bound * bound * bound;
  const Rational constant = plane ? Rational(Integer(4), Integer(3)) : Rational(2);
  return floor_sqrt(power / (constant * gram.determinant())) + 1;
}

Vector to_vector(int dimension, const std::array<std::int64_t, 3>& x) {
  Vector v(dimension);
  for (int i = 0; i < dimension; ++i) v[i] = static_cast<long>(x[static_cast<std::size_t>(i)]);
  return v;
}

/// The nonzero g of L in 4V. g = c - 4s lies in 4V iff s is closest to c/4, so c needs to run through L/4L
/// only: 4^d closest-vector problems, whatever the metric.
std::vector<Vector> vectors_of_four_cells(const Matrix& gram) {
  const int d = gram.dimension();
  const ReducedBasis reduced = reduce_basis(gram);
  const auto small = SmallClosestVectors::make(reduced.gram);
  std::vector<Vector> found;
  for (int code = 0; code < (d == 2 ? 16 : 64); ++code) {
    SmallClosestVectors::Coordinates c{};
    Vector exact(d);
    for (int i = 0, rest = code; i < d; ++i, rest /= 4) {
      c[static_cast<std::size_t>(i)] = rest % 4;
      exact[i] = rest % 4;
    }
    std::vector<Vector> closest;
    if (small) {
      const auto vectors = (*small)(c, 4);
      ensure(vectors.has_value(), "a denominator of 4 fits");
      for (const auto& s : *vectors) closest.push_back(to_vector(d, s));
    } else {
      closest = closest_vectors(reduced.gram, Rational(Integer(1), Integer(4)) * exact);
    }
    for (const Vector& s : closest) {
      const Vector g = exact - Rational(4) * s;
      if (!g.is_zero()) found.push_back(reduced.transform * g);
    }
  }
  return found;
}

}  // namespace

Sublattice theorem10_cover(const Frame& frame, long max_sheets) {
  return to_sublattice(theorem10_lattice(frame), frame, max_sheets);
}

Sublattice one_at_a_time_cover(const Frame& frame, long max_sheets) {
  const Rational bound = single_copy_bound(frame.gram);
  const Integer least = hermite_lower_bound(frame.gram, bound);
  const long max_index = max_sheets / holonomy_order(frame);
  if (least > Integer(max_index))
    throw_too_many("at least ", least * Integer(holonomy_order(frame)), max_sheets);

  const DiagonalLattice product = product_lattice(frame), multiple = theorem10_lattice(frame);
  const DiagonalLattice& simple = product.index() <= multiple.index() ? product : multiple;
  if (least > Integer(frame.dimension == 2 ? kMaxSearchedIndexInPlane : kMaxSearchedIndexInSpace))
    return to_sublattice(simple, frame, max_sheets);

  // Some lattice of the index of `simple` passes, so the loop ends there at the latest.
  SublatticeSearch search(frame, short_vectors(frame.gram, bound), kMaxSearchWork);
  for (long index = least.to_long(); index <= max_index; ++index) {
    if (auto found = search.least_of_index(index)) return *std::move(found);
    if (search.exhausted()) return to_sublattice(simple, frame, max_sheets);
    ensure(Integer(index) < simple.index(), "the search finds the product lattice");
  }
  throw_too_many("more than ", max_index * holonomy_order(frame), max_sheets);
}

Sublattice complete_orbit_cover(const Frame& frame) {
  return smallest_cover_without(frame, vectors_of_four_cells(frame.gram));
}

Sublattice smallest_cover_without(const Frame& frame, const std::vector<Vector>& vectors) {
  // At most 27 indices and 250 vectors: no limit on the work.
  SublatticeSearch search(frame, vectors, std::numeric_limits<long>::max());
  for (long index = 1; index <= (frame.dimension == 2 ? 9 : 27); ++index)
    if (auto found = search.least_of_index(index)) return *std::move(found);
  throw InternalError("3L meets 4V in 0 only");
}

bool is_safe_for_single_copies(const Matrix& gram, const Matrix& sublattice) {
  return shortest_squared_length(sublattice.transpose() * gram * sublattice) > single_copy_bound(gram);
}

bool is_safe_for_complete_orbits(const Matrix& gram, const Matrix& sublattice) {
  const Matrix to_sublattice_coordinates = sublattice.inverse();
  const std::vector<Vector> inside = vectors_of_four_cells(gram);
  return std::none_of(inside.begin(), inside.end(),
                      [&](const Vector& g) { return (to_sublattice_coordinates * g).is_integral(); });
}

}  // namespace flatdt::ref
