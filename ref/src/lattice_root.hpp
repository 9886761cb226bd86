/// Integer square roots of exact numbers.
#pragma once

#include <gmpxx.h>

#include "flatdt/ref/exact.hpp"

namespace flatdt::ref {

/// The greatest integer c with c^2 <= x. Requires: x >= 0.
inline Integer floor_sqrt(const Rational& x) {
  return Integer(mpz_class(sqrt(floor(x).mpz())));
}

}  // namespace flatdt::ref
