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

  /// Nothing if some entry of gram, cleared of denominators, is not below 2^60.
  /// Requires: the columns of the identity and minus their sum are an obtuse superbase for gram.
  static std::optional<SmallClosestVectors> make(const Matrix& gram);

  /// All lattice vectors closest to numerators / denominator, in no particular order; nothing where the
  /// numbers do not fit. Bounds, with gram's integers below 2^g and the denominator below 2^b: the descent
  /// takes at most d steps by vectors of -1, 0 and 1 from [0,1)^d (lattice_descent.hpp), and coordinates of
  /// closest vectors differ by at most d: in Selling's form, sum p_ij (x_i - x_j)^2 with x_0 = 0, by at most
  /// 1 along each p_ij > 0. So coordinates are below 8 * 2^b and products below 2^(g+b+8); b <= 60 and g + b
  /// + 8 <= 126 are needed. Requires: denominator > 0.
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
