/// Shrinking: from a specimen to simpler ones, until few points with short rationals on a simple manifold
/// with its canonical metric in catalogue coordinates are left.
/// Laws: every result is valid, in the domain, and of smaller weight(); weights are well-ordered, so that
/// repeated simplification ends.
#pragma once

#include <compare>
#include <vector>

#include "flatdt/testing/draw.hpp"

namespace flatdt::testing {

/// Numbers simpler than x: 0, x mod 1, approximations of both with small denominators, x / 2 and x -+ 1.
/// Each has a smaller denominator, or the same and a smaller absolute numerator.
std::vector<ref::Rational> simpler(const ref::Rational& x);

/// Specimens simpler than s that stay in the domain, the boldest first: a simpler manifold; catalogue
/// coordinates, generators, metric and name; fewer points; simpler numbers; choice 0.
std::vector<Specimen> simpler(const Specimen& s, const Domain& domain);

/// What shrinking decreases, compared lexicographically.
struct Weight {
  std::size_t manifold = 0;  // place in domain.manifolds
  std::size_t points = 0;
  std::size_t description = 0;   // is anything but the points not the catalogue's? how many bits has it?
  std::size_t denominators = 0;  // bits of all coordinates
  std::size_t numerators = 0;
  std::uint64_t choice = 0;
  friend auto operator<=>(const Weight&, const Weight&) = default;
};
Weight weight(const Specimen& s, const Domain& domain);

}  // namespace flatdt::testing
