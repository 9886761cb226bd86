// Subgroups of Q^d generated one vector at a time, in row Hermite normal form over one common denominator.
//
// Invariants: row c, if present, has its first nonzero entry in column c, and it is positive; the entries of
// other rows in that column lie in [0, pivot).   Source: [Cohen93, section 2.4].
#pragma once

#include <array>
#include <optional>

#include "flatdt/checker/exact.hpp"

namespace flatdt::checker {

/// Numerators and common denominators of groups may have this many bits (a limit of the checker's own): every
/// decimal token of an input fits; a hexadecimal one with the largest exponent, and common denominators of
/// many different numbers, may not.
inline constexpr std::size_t kMaxGroupBits = 20'000;

/// Throws ResourceLimit if x has more than kMaxGroupBits bits; `what` names it.
void require_size(const Integer& x, const char* what);

class Lattice {
 public:
  explicit Lattice(int dimension) : dimension_(static_cast<std::size_t>(dimension)) {}

  /// Adds a generator.   Errors: ResourceLimit above kMaxGroupBits.
  void insert(const Vec<Rational>& v);
  [[nodiscard]] bool contains(const Vec<Rational>& v) const;
  [[nodiscard]] int rank() const;
  /// A basis as columns.   Requires: full rank.
  [[nodiscard]] Mat<Rational> basis() const;
  /// Replaces v by the representative of v + lattice with entry c in [0, pivot of row c).
  /// Requires: full rank, all vectors integral.
  void reduce(Vec<Integer>& v) const;

 private:
  void insert_integral(Vec<Integer> v);
  void normalise();

  std::size_t dimension_;
  Integer denominator_ = 1;
  std::array<std::optional<Vec<Integer>>, 3> rows_;
};

}  // namespace flatdt::checker
