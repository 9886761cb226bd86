/// Edits of the points and the metric: what they make of the same complex is decided in reposition.hpp.
#include "draft.hpp"
#include "flatdt/ref/families.hpp"
#include "reposition.hpp"

namespace flatdt::edits {

using Name = checker::ConditionName;
using ref::Integer;
using ref::Isometry;
using ref::Rational;
using ref::Vector;

namespace {

Rational power_of_half(int exponent) {
  Integer denominator(1);
  for (int i = 0; i < exponent; ++i) denominator *= Integer(2);
  return {Integer(1), denominator};
}

/// One point moved by `step` times a small integer vector; the files if that has the wanted effect. Requires:
/// points in different orbits.
std::optional<Files> moved_point(const Base& base, Random& random, const Rational& step,
                                 Repositioned wanted) {
  if (!base.points_are_distinct()) return std::nullopt;
  for (int attempt = 0; attempt < 3; ++attempt) {
    Draft draft(base);
    Vector& p = draft.instance().points[random.below(base.instance().points.size())];
    Vector by(base.dimension());
    while (by.is_zero())
      for (int k = 0; k < base.dimension(); ++k) by[k] = step * Rational(random.between(-1, 1));
    p = p + by;
    if (points_stay_distinct(base, draft.instance()) && repositioned(base, draft.data()) == wanted)
      return draft.files();
  }
  return std::nullopt;
}

auto move_slightly(Repositioned wanted) {
  return [wanted](const Base& base, Random& random) {
    return moved_point(base, random, power_of_half(60), wanted);
  };
}

auto move_far(Repositioned wanted) {
  return [wanted](const Base& base, Random& random) {
    const int shortest = wanted == Repositioned::folded ? 1 : 4;
    return moved_point(base, random, power_of_half(random.between(shortest, shortest + 6)), wanted);
  };
}

/// The points of another set of the same size on the same manifold, with the group and metric of the base.
std::optional<Files> other_points(const Base& base, Random& random) {
  const ref::Instance& old = base.instance();
  if (!base.points_are_distinct() || !old.name) return std::nullopt;
  const ref::CatalogueEntry* entry = ref::find_entry(*old.name);
  Draft draft(base);
  draft.instance().points = ref::generate(*entry, *old.name, "uniform", static_cast<long>(old.points.size()),
                                          random.next(), "canonical")
                                .points;
  if (!points_stay_distinct(base, draft.instance())) return std::nullopt;
  if (repositioned(base, draft.data()) == Repositioned::valid) return std::nullopt;
  return draft.files();
}

std::optional<Files> further_point(const Base& base, Random& random) {
  Draft draft(base);
  Vector p(base.dimension());
  for (int k = 0; k < base.dimension(); ++k)
    p[k] = Rational(Integer(random.between(-999, 999)), Integer(997));
  for (const Vector& q : base.instance().points)
    if (base.group().canonical(p).point == base.group().canonical(q).point) return std::nullopt;
  draft.instance().points.push_back(p);
  return draft.files();
}

bool is_invariant(const Base& base, const ref::Matrix& gram) {
  for (const Isometry& g : base.instance().generators)
    if (g.linear.transpose() * gram * g.linear != gram) return false;
  return true;
}

/// An entry of the Gram matrix changed, so that some generator is no isometry.
std::optional<Files> metric_not_invariant(const Base& base, Random& random, const Rational& by) {
  const auto d = static_cast<std::size_t>(base.dimension());
  for (const std::size_t entry : random.order(d * d)) {
    const int i = static_cast<int>(entry / d);
    const int j = static_cast<int>(entry % d);
    Draft draft(base);
    ref::Matrix& gram = draft.instance().gram;
    gram(i, j) += by;
    if (i != j) gram(j, i) += by;
    if (ref::is_positive_definite(gram) && !is_invariant(base, gram)) return draft.files();
  }
  return std::nullopt;
}

std::optional<Files> metric_off(const Base& base, Random& random) {
  return metric_not_invariant(base, random, Rational(Integer(1), Integer(random.between(3, 9))));
}
std::optional<Files> metric_off_slightly(const Base& base, Random& random) {
  return metric_not_invariant(base, random, power_of_half(60));
}

/// Another invariant metric: the mean over the holonomy of a random change.
auto other_metric(Repositioned wanted) {
  return [wanted](const Base& base, Random& random) -> std::optional<Files> {
    for (int attempt = 0; attempt < 3; ++attempt) {
      Draft draft(base);
      const ref::Matrix& old = base.instance().gram;
      ref::Matrix change(base.dimension());
      const Rational size(Integer(1),
                          Integer(wanted == Repositioned::valid ? 100000 : random.between(2, 12)));
      for (int i = 0; i < base.dimension(); ++i)
        for (int j = 0; j <= i; ++j) {
          change(i, j) = size * Rational(random.between(-3, 3)) * old(i, i);
          change(j, i) = change(i, j);
        }
      ref::Matrix mean(base.dimension());
      for (const Isometry& r : base.group().cosets()) mean = mean + r.linear.transpose() * change * r.linear;
      ref::Matrix& gram = draft.instance().gram;
      gram = old + Rational(Integer(1), Integer(static_cast<long>(base.group().cosets().size()))) * mean;
      if (gram == old || !ref::is_positive_definite(gram)) continue;
      if (repositioned(base, draft.data()) == wanted) return draft.files();
    }
    return std::nullopt;
  };
}

}  // namespace

std::vector<Kind> point_kinds() {
  const Conditions complex = {Name::vertices_complete, Name::facets_paired};
  const Conditions tiling = {Name::vertices_complete, Name::cells_nondegenerate, Name::facets_paired,
                             Name::facets_opposite, Name::volume_exact};
  const Expectation not_delaunay = breaks({Name::delaunay_empty}, {}, tiling);
  const std::string_view moved = "the same complex, its vertices elsewhere (reposition.hpp)";
  return {
      {"point moved by 2^-60, breaking a tie", moved, not_delaunay,
       move_slightly(Repositioned::not_delaunay)},
      {"point moved by 2^-60, breaking none", moved, keeps(), move_slightly(Repositioned::valid)},
      {"point moved, cells in place", moved, not_delaunay, move_far(Repositioned::not_delaunay)},
      {"point moved, no cell changes", moved, keeps(), move_far(Repositioned::valid)},
      {"point moved through a facet", moved,
       breaks({Name::volume_exact, Name::facets_opposite}, {},
              {Name::vertices_complete, Name::cells_nondegenerate, Name::facets_paired}),
       move_far(Repositioned::folded)},
      {"points of another set", moved,
       breaks({}, {Name::cells_nondegenerate, Name::volume_exact, Name::delaunay_empty}, complex),
       other_points},
      {"further point in the instance", "it is no vertex",
       breaks({Name::vertices_complete}, {},
              {Name::cells_nondegenerate, Name::facets_paired, Name::facets_opposite, Name::volume_exact}),
       further_point},
      {"metric not invariant", "some generator is no isometry", breaks({Name::group_crystallographic}),
       metric_off},
      {"metric not invariant by 2^-60", "some generator is no isometry",
       breaks({Name::group_crystallographic}), metric_off_slightly},
      {"another invariant metric", moved, not_delaunay, other_metric(Repositioned::not_delaunay)},
      {"another invariant metric, slightly", moved, keeps(), other_metric(Repositioned::valid)},
  };
}

}  // namespace flatdt::edits
