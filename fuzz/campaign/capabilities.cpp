#include "capabilities.hpp"

#include <algorithm>

#include "metrics.hpp"

namespace flatdt::campaign {
namespace {

using ref::Integer;
using ref::Rational;
using ref::Vector;
using testing::Specimen;

/// 2^50: sums of a few multiples of 2^-50 in [0,1) are exact in doubles.
const Integer& double_denominator() {
  static const Integer kDenominator(1L << 50);
  return kDenominator;
}

bool is_double(const Rational& x) {
  return x >= Rational(0) && x < Rational(1) &&
         (Rational(double_denominator()) * x).denominator() == Integer(1);
}

bool same_orbit(const Vector& x, const Vector& y, const std::vector<ref::Isometry>& cosets) {
  return std::any_of(cosets.begin(), cosets.end(),
                     [&](const ref::Isometry& g) { return (g * x - y).is_integral(); });
}

bool is_plain(const Specimen& s) {
  return s.naming == testing::Naming::name_only && s.coordinates.is_identity() &&
         s.generators == testing::catalogue_generators(s);
}

bool has_repetition(const Specimen& s) {
  const std::vector<ref::Isometry> cosets = testing::cosets_of(testing::catalogue_generators(s));
  for (std::size_t i = 0; i < s.points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (same_orbit(s.points[i], s.points[j], cosets)) return true;
  return false;
}

void leave_out_repetitions(Specimen& s) {
  const std::vector<ref::Isometry> cosets = testing::cosets_of(testing::catalogue_generators(s));
  std::vector<Vector> kept;
  for (const Vector& x : s.points)
    if (std::none_of(kept.begin(), kept.end(), [&](const Vector& y) { return same_orbit(x, y, cosets); }))
      kept.push_back(x);
  s.points = std::move(kept);
}

}  // namespace

bool accepts(const Capabilities& capabilities, const Specimen& s) {
  const auto& names = capabilities.manifolds;
  const bool known = names.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& name) {
                       return ref::find_entry(name) == s.entry;
                     });
  if (!known || s.points.size() < capabilities.min_points) return false;
  const auto& most = s.dimension() == 2 ? capabilities.max_points_in_plane : capabilities.max_points_in_space;
  if (most && s.points.size() > *most) return false;
  if (capabilities.canonical_metric_only && s.gram != s.entry->canonical_gram) return false;
  if (capabilities.names_only && !is_plain(s)) return false;
  if (capabilities.doubles_only)
    for (const Vector& x : s.points)
      for (int k = 0; k < x.dimension(); ++k)
        if (!is_double(x[k])) return false;
  return !capabilities.distinct_only || !has_repetition(s);
}

Specimen conform(const Capabilities& capabilities, Specimen s) {
  if (capabilities.canonical_metric_only) s.gram = s.entry->canonical_gram;
  if (capabilities.names_only) {
    s.coordinates = ref::Isometry::identity(s.dimension());
    s.generators = testing::catalogue_generators(s);
    s.naming = testing::Naming::name_only;
  }
  if (capabilities.doubles_only)
    for (Vector& x : s.points)
      for (int k = 0; k < x.dimension(); ++k) {
        const Rational inside = x[k] - Rational(floor(x[k]));
        x[k] = Rational(floor(Rational(double_denominator()) * inside), double_denominator());
      }
  if (capabilities.distinct_only) leave_out_repetitions(s);
  return s;
}

}  // namespace flatdt::campaign
