/// Moves of the metric. For a named group the decoder takes the mean over the linear parts: the result is
/// admissible whatever the move.
#include "moves.hpp"

namespace flatdt::fuzz {

using ref::Integer;
using ref::Matrix;
using ref::Rational;

bool move_metric(Specimen& specimen, Random& random) {
  const int d = specimen.dimension();
  Matrix gram = metric_of(specimen);
  const int i = random.below(d);
  const int j = random.below(d);
  switch (random.below(7)) {
    case 0:
      specimen.gram.reset();
      return true;
    case 1:  // another scale
      gram = abs(simple_rational(random)) * gram;
      break;
    case 2: {  // a longer or shorter axis
      const Integer denominator = 1 + random.below(8);
      const Rational factor(Integer(1 + random.below(8)), denominator);
      for (int k = 0; k < d; ++k) {
        gram(i, k) = factor * gram(i, k);
        gram(k, i) = factor * gram(k, i);
      }
      break;
    }
    case 3: {  // a near tie between lengths or angles
      const Rational delta = tiny_rational(random);
      gram(i, j) += delta;
      if (i != j) gram(j, i) = gram(i, j);
      break;
    }
    case 4:
      gram(i, j) = simple_rational(random);
      gram(j, i) = gram(i, j);
      break;
    case 5:  // two axes of one length
      gram(i, i) = gram(j, j);
      break;
    default: {  // sheared: another basis of a lattice not far off
      if (i == j) return false;
      Matrix shear = Matrix::identity(d);
      shear(i, j) = random.one_in(2) ? Rational(random.below(5) - 2) : simple_rational(random);
      gram = shear.transpose() * gram * shear;
      break;
    }
  }
  specimen.gram = gram;
  return true;
}

}  // namespace flatdt::fuzz
