#include "metrics.hpp"

#include <algorithm>

#include "flatdt/ref/errors.hpp"

namespace flatdt::testing {
namespace {

using ref::Integer;
using ref::Isometry;
using ref::Matrix;
using ref::Rational;
using ref::Vector;

Rational power_of_two(int exponent) {
  Integer power(1);
  for (int i = 0; i < std::abs(exponent); ++i) power += power;
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

/// A^T D A with A unit triangular and entries at most 1/2, D diagonal in [1, 2].
Matrix random_positive_definite(int d, Random& random) {
  Matrix a = Matrix::identity(d);
  Matrix diagonal(d);
  for (int i = 0; i < d; ++i) {
    diagonal(i, i) = random.fraction(6, 12, 6);
    for (int j = 0; j < i; ++j) a(i, j) = random.fraction(-2, 2, 4);
  }
  return a.transpose() * diagonal * a;
}

/// Classes of axes that some linear part mixes, each axis with the least of its class.
std::vector<int> axis_classes(const std::vector<Isometry>& cosets, int d) {
  std::vector<int> least;
  for (int i = 0; i < d; ++i) {
    least.push_back(i);
    for (int j = 0; j < i; ++j)
      for (const Isometry& g : cosets)
        if (!g.linear(i, j).is_zero() || !g.linear(j, i).is_zero())
          least.back() = std::min(least.back(), least[static_cast<std::size_t>(j)]);
  }
  return least;
}

}  // namespace

std::vector<Isometry> cosets_of(const std::vector<Isometry>& generators) {
  const int d = generators.front().dimension();
  const auto reduced = [](Isometry g) {
    for (int i = 0; i < g.dimension(); ++i) g.translation[i] -= Rational(floor(g.translation[i]));
    return g;
  };
  std::vector<Isometry> cosets{Isometry::identity(d)};
  // The list grows by one for each new linear part: a point group of a catalogue entry has at most six.
  for (std::size_t i = 0; i < cosets.size(); ++i)
    for (const Isometry& g : generators) {
      const Isometry product = reduced(cosets[i] * g);
      const bool known = std::any_of(cosets.begin(), cosets.end(),
                                     [&](const Isometry& c) { return c.linear == product.linear; });
      if (!known) cosets.push_back(product);
      ref::ensure(cosets.size() <= 6, "a catalogue group has at most six linear parts");
    }
  return cosets;
}

Matrix averaged(const Matrix& m, const std::vector<Isometry>& cosets) {
  Matrix sum(m.dimension());
  for (const Isometry& g : cosets) sum = sum + g.linear.transpose() * m * g.linear;
  return Rational(Integer(1), Integer(static_cast<long>(cosets.size()))) * sum;
}

bool is_admissible(const Matrix& gram, const std::vector<Isometry>& cosets) {
  return ref::is_positive_definite(gram) && std::all_of(cosets.begin(), cosets.end(), [&](const Isometry& g) {
           return ref::preserves_metric(g.linear, gram);
         });
}

Matrix stretched_metric(const Matrix& gram, const std::vector<Isometry>& cosets, long max_stretch,
                        Random& random) {
  const int d = gram.dimension();
  const std::vector<int> classes = axis_classes(cosets, d);
  std::vector<Rational> factor;
  factor.reserve(static_cast<std::size_t>(d));
  for (int i = 0; i < d; ++i) factor.emplace_back(random.between(1, max_stretch));
  Matrix result(d);
  for (int i = 0; i < d; ++i)
    for (int j = 0; j < d; ++j)
      result(i, j) = gram(i, j) * factor[static_cast<std::size_t>(classes[static_cast<std::size_t>(i)])] *
                     factor[static_cast<std::size_t>(classes[static_cast<std::size_t>(j)])];
  return result;
}

Matrix draw_metric(const Matrix& canonical, const std::vector<Isometry>& cosets, long max_stretch,
                   Random& random) {
  const int d = canonical.dimension();
  Matrix gram = canonical;
  switch (random.below(6)) {
    case 0:
    case 1:
      gram = averaged(random_positive_definite(d, random), cosets);
      break;
    case 2: {
      const Matrix change = averaged(random_positive_definite(d, random), cosets);
      gram = canonical + power_of_two(-static_cast<int>(random.between(10, 70))) * change;
      break;
    }
    case 3:
      gram = stretched_metric(canonical, cosets, max_stretch, random);
      break;
    default:
      break;
  }
  if (random.one_in(6)) gram = random.fraction(1, 9, 7) * gram;
  if (random.one_in(12)) gram = power_of_two(static_cast<int>(random.between(-400, 400))) * gram;
  return gram;
}

}  // namespace flatdt::testing
