/// Closest lattice vectors in machine integers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flatdt/ref/linear.hpp"
#include "flatdt/ref/wide_integer.hpp"

namespace flatdt::ref {

/// closest_vectors (lattice.hpp; there the reasons) for a reduced Gram matrix of small numbers.
class SmallClosestVectors {
 public:
  using Coordinates = std::array<std::int64_t, 3>;

  /// Nothing if some entry of gram, cleared of denominators, is not below 2^62.
  /// Requires: the columns of the identity and minus their sum are an obtuse superbase for gram.
  static std::optional<SmallClosestVectors> make(const Matrix& gram);

  /// All lattice vectors closest to numerators / denominator, in no particular order; nothing where the
  /// numbers do not fit: with gram's integers below 2^g and the denominator below 2^b, all coordinates are
  /// below 4 * 2^b on the way and the products below 2^(g+b+8), so g + b + 8 <= 126 is needed. Requires:
  /// denominator > 0.
  [[nodiscard]] std::optional<std::vector<Coordinates>> operator()(const Coordinates& numerators,
                                                                   std::int64_t denominator) const;

 private:
  /// A sum of a proper subset of the superbase.
  struct Relevant {
    Coordinates n;
    Coordinates image;  // G n
    Int128 squared;     // <n,n>
  };

  std::size_t dimension_ = 0;
  int bits_ = 0;
  std::vector<Relevant> relevant_;
};

}  // namespace flatdt::ref
