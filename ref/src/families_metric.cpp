#include <array>

#include "families_internal.hpp"

namespace flatdt::ref::families_detail {
namespace {

/// Axis j is in the class of axis i if some linear part mixes them: the least axis of each class.
std::vector<int> axis_classes(const std::vector<Isometry>& cosets, int dimension) {
  std::vector<int> least(static_cast<std::size_t>(dimension));
  for (int i = 0; i < dimension; ++i) {
    least[static_cast<std::size_t>(i)] = i;
    for (int j = i - 1; j >= 0; --j)
      for (const Isometry& g : cosets)
        if (!g.linear(i, j).is_zero() || !g.linear(j, i).is_zero())
          least[static_cast<std::size_t>(i)] = least[static_cast<std::size_t>(j)];
  }
  return least;
}

Matrix random_shear(int dimension, bool lower, Random& random) {
  Matrix shear = Matrix::identity(dimension);
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < i; ++j) (lower ? shear(i, j) : shear(j, i)) = random.between(-9, 9);
  return shear;
}

}  // namespace

Matrix random_gram(const Matrix& canonical, const std::vector<Isometry>& cosets, Random& random) {
  // M = D C D + E with C the canonical matrix (eigenvalues >= 1/2), D diagonal in [1,2] and E symmetric with
  // zero diagonal and |entries| <= 3/16. |D x|^2 / 2 - 2 (3/16) |x|^2 > 0, so M is positive definite.
  const int d = canonical.dimension();
  const Rational eighth(Integer(1), Integer(8)), sixteenth(Integer(1), Integer(16));
  Vector scale(d);
  for (int i = 0; i < d; ++i) scale[i] = Rational(random.between(8, 16)) * eighth;
  Matrix m(d);
  for (int i = 0; i < d; ++i) {
    m(i, i) = canonical(i, i) * scale[i] * scale[i];
    for (int j = 0; j < i; ++j)
      m(i, j) = m(j, i) = canonical(i, j) * scale[i] * scale[j] + Rational(random.between(-3, 3)) * sixteenth;
  }
  // The mean of R^T M R over the point group is positive definite and invariant, and every invariant Gram
  // matrix is its own mean: the whole cone can be met.
  Matrix sum(d);
  for (const Isometry& g : cosets) sum = sum + g.linear.transpose() * m * g.linear;
  return Rational(Integer(1), Integer(static_cast<long>(cosets.size()))) * sum;
}

Matrix stretched_gram(const Matrix& gram, const std::vector<Isometry>& cosets, Random& random) {
  constexpr std::array<long, 5> kRatios = {10, 30, 100, 300, 1000};
  const int d = gram.dimension();
  const std::vector<int> classes = axis_classes(cosets, d);
  const long longest = kRatios[random.below(kRatios.size())];
  // One class of axes gets the longest factor, one keeps 1, a third anything between. Every entry of the
  // catalogue has at least two classes.
  std::vector<int> axes;
  for (int i = 0; i < d; ++i)
    if (classes[static_cast<std::size_t>(i)] == i) axes.push_back(i);
  const std::size_t stretched = random.below(axes.size());
  const std::size_t kept = (stretched + 1 + random.below(axes.size() - 1)) % axes.size();
  std::vector<Rational> factor(static_cast<std::size_t>(d), Rational(1));
  for (std::size_t k = 0; k < axes.size(); ++k)
    factor[static_cast<std::size_t>(axes[k])] = k == stretched ? longest
                                                : k == kept    ? 1
                                                               : random.between(1, longest);
  Matrix result(d);
  for (int i = 0; i < d; ++i)
    for (int j = 0; j < d; ++j)
      result(i, j) = gram(i, j) * factor[static_cast<std::size_t>(classes[static_cast<std::size_t>(i)])] *
                     factor[static_cast<std::size_t>(classes[static_cast<std::size_t>(j)])];
  return result;
}

Instance in_skew_basis(const Instance& instance, Random& random) {
  const int d = instance.dimension;
  const Matrix last = random_shear(d, true, random);
  const Matrix middle = random_shear(d, false, random);
  const Matrix basis = random_shear(d, true, random) * middle * last;
  const Matrix inverse = basis.inverse();
  Instance skew = instance;
  skew.generators_given = true;
  for (Isometry& g : skew.generators) g = {inverse * g.linear * basis, inverse * g.translation};
  skew.gram = basis.transpose() * instance.gram * basis;
  for (Vector& x : skew.points) x = modulo_one(inverse * x);
  return skew;
}

}  // namespace flatdt::ref::families_detail
