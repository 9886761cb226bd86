// A crystallographic group in coordinates of its own lattice, where linear parts and lattice are integral.
//
// Invariants: element (r, l) is {I|l} s_r with s_r = {linear[r] | translation[r]}; index 0 is the identity;
// s_a s_b = {I | cocycle[a][b]} s_{product[a][b]}.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "closure.hpp"
#include "flatdt/checker/exact.hpp"
#include "smith.hpp"

namespace flatdt::checker {

/// {I|shift} s_rotation.
struct Element {
  std::uint8_t rotation = 0;
  Vec<Integer> shift;

  bool operator==(const Element&) const = default;
};

struct Group {
  int dimension;
  Mat<Rational> basis;  ///< columns: the lattice's basis in outer coordinates
  Mat<Rational> basis_inverse;
  std::vector<Mat<Integer>> linear;
  std::vector<Vec<Rational>> translation;  ///< entries in [0,1)
  std::vector<Seitz> representative;       ///< s_r in outer coordinates
  std::vector<std::vector<std::uint8_t>> product;
  std::vector<std::vector<Vec<Integer>>> cocycle;
  std::vector<std::uint8_t> inverse;
  std::vector<bool> reversing;  ///< determinant -1

  [[nodiscard]] std::size_t order() const { return linear.size(); }

  /// The element with these outer coordinates, if it belongs to the group.
  [[nodiscard]] std::optional<Element> locate(const Seitz& g) const;
  [[nodiscard]] Element multiply(const Element& a, const Element& b) const;
  [[nodiscard]] Element invert(const Element& a) const;
  /// In lattice and in outer coordinates.
  [[nodiscard]] Seitz lattice_seitz(const Element& a) const;
  [[nodiscard]] Seitz outer_seitz(const Element& a) const;
};

/// Requires: the crystal's lattice has full rank.
[[nodiscard]] Group make_group(const Crystal& crystal);

/// An element of finite order with a fixed point, in outer coordinates.
struct TorsionElement {
  Seitz element;
  Vec<Rational> fixed_point;
  std::size_t order;
};

/// A non-trivial element of finite order, if there is one.
/// Law:     {R|t+l} has a fixed point iff t + l lies in the image of I - R over Q; with U (I-R) V = diag(D),
/// iff
///          (U (t+l))_i = 0 wherever D_i = 0; U is unimodular, so such an l exists iff those (U t)_i are
///          integers.
/// Source:  docs/soundness.md, section 2.
[[nodiscard]] std::optional<TorsionElement> find_torsion(const Group& group);

/// Whether every linear part has determinant 1.
[[nodiscard]] bool is_orientable(const Group& group);

/// "1", "Z2", "Z3", "Z4", "Z6", "Z2xZ2"; any other group "order-N".
[[nodiscard]] std::string holonomy_name(const Group& group);

/// G/[G,G], from the presentation of G as an extension of its point group by its lattice.
[[nodiscard]] AbelianGroup first_homology(const Group& group);

}  // namespace flatdt::checker
