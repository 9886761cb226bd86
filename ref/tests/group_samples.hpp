/// Groups for tests: instances made from elements, moved to other coordinates, with invariant metrics.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::ref::testing {

inline Matrix make_matrix(int dimension, const std::vector<Rational>& entries) {
  Matrix m(dimension);
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j)
      m(i, j) = entries[static_cast<std::size_t>(i) * static_cast<std::size_t>(dimension) +
                        static_cast<std::size_t>(j)];
  return m;
}

inline Vector make_vector(const std::vector<Rational>& entries) {
  Vector v(static_cast<int>(entries.size()));
  for (int i = 0; i < v.dimension(); ++i) v[i] = entries[static_cast<std::size_t>(i)];
  return v;
}

/// An instance with the point 0.
inline Instance make_instance(const std::vector<Isometry>& generators, const Matrix& gram) {
  Instance instance;
  instance.dimension = gram.dimension();
  instance.generators = generators;
  instance.generators_given = true;
  instance.gram = gram;
  instance.points = {Vector(gram.dimension())};
  return instance;
}

/// The sum of R^T m R over the linear parts: invariant if these are a group.
inline Matrix averaged(const Matrix& m, const std::vector<Isometry>& point_group) {
  Matrix sum(m.dimension());
  for (const Isometry& g : point_group) sum = sum + g.linear.transpose() * m * g.linear;
  return sum;
}

/// A positive definite matrix with small entries and no symmetry to speak of.
inline Matrix random_metric(int dimension, std::mt19937_64& random) {
  Matrix a(dimension);
  do {
    for (int i = 0; i < dimension; ++i)
      for (int j = 0; j < dimension; ++j) a(i, j) = static_cast<int>(random() % 9) - 4;
  } while (a.determinant().is_zero());
  return a.transpose() * a;
}

/// A product of elementary matrices, of determinant +-1.
inline Matrix random_unimodular(int dimension, std::mt19937_64& random) {
  Matrix u = Matrix::identity(dimension);
  if (dimension < 2) return u;
  for (int step = 0; step < 6; ++step) {
    const int i = static_cast<int>(random() % static_cast<unsigned>(dimension));
    const int j = (i + 1 + static_cast<int>(random() % static_cast<unsigned>(dimension - 1))) % dimension;
    Matrix elementary = Matrix::identity(dimension);
    elementary(i, j) = static_cast<int>(random() % 5) - 2;
    if (random() % 4 == 0) elementary(i, i) = -1;
    u = u * elementary;
  }
  return u;
}

inline Vector random_origin(int dimension, std::mt19937_64& random) {
  Vector v(dimension);
  for (int i = 0; i < dimension; ++i)
    v[i] = Rational(Integer(static_cast<long>(random() % 41) - 20), Integer(7));
  return v;
}

/// The same group, metric and points in the coordinates y = u x + o.
inline Instance moved(const Instance& instance, const Matrix& u, const Vector& o) {
  const Isometry map{u, o};
  const Matrix inverse = u.inverse();
  Instance result = instance;
  for (Isometry& g : result.generators) g = map * g * map.inverse();
  result.gram = inverse.transpose() * instance.gram * inverse;
  for (Vector& x : result.points) x = map * x;
  return result;
}

/// Conjugating the catalogue's generators by the frame gives elements of the group, the frame's cosets are
/// those of the analysis, and its metric and basis fit: all recomputed here.
inline void expect_frame_holds(const GroupAnalysis& analysis, const Matrix& gram) {
  const Frame& frame = analysis.frame;
  const int d = frame.dimension;
  EXPECT_EQ(frame.basis.transpose() * gram * frame.basis, frame.gram);
  const Matrix to_basis = frame.basis.inverse();
  EXPECT_TRUE((to_basis * analysis.lattice).is_integral());
  EXPECT_EQ(abs((to_basis * analysis.lattice).determinant()), Rational(1));
  EXPECT_TRUE(frame.to_catalogue.is_integral());
  EXPECT_EQ(abs(frame.to_catalogue.determinant()), Rational(1));

  const Isometry to_instance{frame.basis, frame.origin};
  ASSERT_EQ(frame.cosets.size(), analysis.cosets.size());
  EXPECT_TRUE(frame.cosets[0].is_identity());
  for (const Isometry& g : frame.cosets) {
    for (int i = 0; i < d; ++i) {
      EXPECT_TRUE(g.translation[i] >= Rational(0) && g.translation[i] < Rational(1));
      EXPECT_TRUE((Rational(frame.translation_denominator) * g.translation[i]).is_integer());
    }
    const Isometry h = to_instance * g * to_instance.inverse();
    bool found = false;
    for (const Isometry& coset : analysis.cosets)
      found = found ||
              (coset.linear == h.linear && (to_basis * (coset.translation - h.translation)).is_integral());
    EXPECT_TRUE(found) << h.to_string();
  }
  const Isometry from_catalogue{frame.to_catalogue.inverse(), Vector(d)};
  const auto& generators =
      frame.mirrored ? analysis.entry->mirror_image_generators : analysis.entry->generators;
  for (const Isometry& g : generators) {
    const Isometry h = from_catalogue * g * from_catalogue.inverse();
    bool found = false;
    for (const Isometry& coset : frame.cosets)
      found = found || (coset.linear == h.linear && (coset.translation - h.translation).is_integral());
    EXPECT_TRUE(found) << h.to_string();
  }
}

}  // namespace flatdt::ref::testing
