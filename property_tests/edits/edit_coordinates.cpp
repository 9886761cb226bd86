/// The same triangulation in other coordinates, or with another unit of length: all of these keep it valid.
#include "draft.hpp"

namespace flatdt::edits {

using ref::Integer;
using ref::Isometry;
using ref::Rational;
using ref::Vector;

namespace {

/// Everything written in the coordinates y = A x.
Files in_coordinates(const Base& base, const Isometry& a) {
  const Isometry back = a.inverse();
  const auto conjugated = [&](const std::vector<Isometry>& all) {
    std::vector<Isometry> now;
    now.reserve(all.size());
    for (const Isometry& g : all) now.push_back(a * g * back);
    return now;
  };
  Draft draft(base);
  draft.set_generators(conjugated(base.instance().generators));
  draft.instance().gram = back.linear.transpose() * base.instance().gram * back.linear;
  for (Vector& p : draft.instance().points) p = a * p;
  draft.triangulation().elements = conjugated(base.triangulation().elements);
  draft.triangulation().subgroup = conjugated(base.triangulation().subgroup);
  return draft.files();
}

std::optional<Files> other_basis(const Base& base, Random& random) {
  Isometry a = Isometry::identity(base.dimension());
  do
    for (int i = 0; i < base.dimension(); ++i) {
      for (int j = 0; j < base.dimension(); ++j)
        a.linear(i, j) = Rational(Integer(random.between(-3, 3)), Integer(2));
      a.translation[i] = Rational(Integer(random.between(-20, 20)), Integer(7));
    }
  while (a.linear.determinant().is_zero());
  return in_coordinates(base, a);
}

std::optional<Files> mirror_image(const Base& base, Random& random) {
  Isometry a = Isometry::identity(base.dimension());
  const int axis = random.between(0, base.dimension() - 1);
  a.linear(axis, axis) = Rational(-1);
  return in_coordinates(base, a);
}

std::optional<Files> origin_moved_with_all(const Base& base, Random& random) {
  Vector by(base.dimension());
  for (int k = 0; k < base.dimension(); ++k) by[k] = Rational(Integer(random.between(-99, 99)), Integer(64));
  return in_coordinates(base, Isometry::translate(by));
}

std::optional<Files> metric_scaled(const Base& base, Random& random) {
  Draft draft(base);
  const Integer denominator(random.between(1, 1000));
  const Rational factor(Integer(random.between(1, 1000)), denominator);
  draft.instance().gram = factor * base.instance().gram;
  return draft.files();
}

}  // namespace

std::vector<Kind> coordinate_kinds() {
  return {
      {"other coordinates", "everything is affine", keeps(), other_basis},
      {"mirror image of everything", "everything is affine", keeps(), mirror_image},
      {"everything moved", "everything is affine", keeps(), origin_moved_with_all},
      {"metric scaled", "balls stay balls", keeps(), metric_scaled},
  };
}

}  // namespace flatdt::edits
