#include "flatdt/ref/sites.hpp"

#include <algorithm>
#include <optional>

#include "small_sites.hpp"

namespace flatdt::ref {
namespace {

// Covers decimals to 10^-1100 and binary fractions to 2^-4400. The exact predicates multiply up to five such
// denominators: measured, four points within 10^-10 of one another with 20,000 bits each take over a minute.
constexpr std::size_t kMaxDenominatorBits = 8192;
// Below this size one common denominator for all sites makes the exact predicates cheapest (no rescaling);
// above it the cost of long numbers in every predicate outweighs the cost of rescaling d+2 points.
constexpr std::size_t kCommonDenominatorBits = 256;

struct Canonical {
  Vector c;           // canonical representative, catalogue coordinates
  Isometry to_point;  // p = to_point * c, catalogue coordinates
  std::uint32_t point;
};

Vector floor_vector(const Vector& v) {
  Vector f(v.dimension());
  for (int i = 0; i < v.dimension(); ++i) f[i] = Rational(floor(v[i]));
  return f;
}

Integer common_denominator(const Vector& v) {
  Integer d = 1;
  for (int i = 0; i < v.dimension(); ++i) d = lcm(d, v[i].denominator());
  return d;
}

}  // namespace

std::vector<Site> make_general_sites(const Frame& frame, const SiteMaps& maps,
                                     const std::vector<Vector>& points) {
  const int d = frame.dimension;
  const Isometry frame_to_catalogue{frame.to_catalogue, Vector(d)};

  std::vector<Canonical> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector x = maps.to_catalogue * points[i];
    std::optional<Canonical> best;
    for (const Isometry& r : maps.catalogue_cosets) {
      const Vector y = r * x;
      const Vector shift = floor_vector(y);
      const Vector c = y - shift;
      // c = (T(-shift) r) x, so x = (T(-shift) r)^-1 c.
      if (!best || c < best->c)
        best = Canonical{c, (Isometry::translate(-shift) * r).inverse(), static_cast<std::uint32_t>(i)};
    }
    all.push_back(std::move(*best));
  }
  std::sort(all.begin(), all.end(), [](const Canonical& a, const Canonical& b) {
    const auto order = a.c <=> b.c;
    return order != std::strong_ordering::equal ? order == std::strong_ordering::less : a.point < b.point;
  });
  all.erase(
      std::unique(all.begin(), all.end(), [](const Canonical& a, const Canonical& b) { return a.c == b.c; }),
      all.end());

  const Integer translation_denominator(static_cast<long>(frame.translation_denominator));
  std::vector<Site> sites(all.size());
  std::vector<Vector> positions;
  std::vector<LargeSite> exact;
  Integer common = translation_denominator;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Canonical& k = all[i];
    const Vector y = maps.from_catalogue * k.c;
    const Vector shift = floor_vector(y);
    positions.push_back(y - shift);
    if (common.bits() <= kCommonDenominatorBits) common = lcm(common, common_denominator(positions.back()));
    sites[i].point = k.point;
    // p = to_point c (catalogue) = (F^-1 to_point F) T(shift) d in the frame, F = to_catalogue.
    exact.push_back(
        {{}, {}, {}, maps.from_catalogue * k.to_point * frame_to_catalogue * Isometry::translate(shift)});
  }
  for (std::size_t i = 0; i < sites.size(); ++i) {
    Site& site = sites[i];
    const Integer own = lcm(translation_denominator, common_denominator(positions[i]));
    if (own.bits() > kMaxDenominatorBits)
      throw LimitReached("point " + std::to_string(site.point) + " has a common denominator of " +
                         std::to_string(own.bits()) + " bits in the lattice frame; the limit is 8192");
    const Integer denominator = common.bits() <= kCommonDenominatorBits ? common : own;
    exact[i].denominator = denominator.mpz();
    for (int j = 0; j < d; ++j) {
      const auto k = static_cast<std::size_t>(j);
      const Rational scaled = positions[i][j] * Rational(denominator);
      ensure(scaled.is_integer(), "the denominator clears every coordinate");
      exact[i].numerators[k] = scaled.numerator().mpz();
      exact[i].approximate[k] = positions[i][j].to_double();
    }
    SiteForm form;
    form.large = std::make_unique<const LargeSite>(std::move(exact[i]));
    site.form = std::make_shared<const SiteForm>(std::move(form));
  }
  return sites;
}

SiteMaps::SiteMaps(const Frame& frame)
    : to_catalogue(Isometry{frame.to_catalogue, Vector(frame.dimension)} *
                   Isometry{frame.basis, frame.origin}.inverse()),
      from_catalogue{frame.to_catalogue.inverse(), Vector(frame.dimension)} {
  for (const Isometry& g : frame.cosets) {
    catalogue_cosets.push_back(Isometry{frame.to_catalogue, Vector(frame.dimension)} * g * from_catalogue);
    std::uint16_t k = 0;
    while (!(frame.cosets[k].linear * g.linear).is_identity()) ++k;
    inverse_coset.push_back(k);
  }
}

std::vector<Site> make_sites(const Frame& frame, const SiteMaps& maps, const std::vector<Vector>& points) {
  if (auto sites = make_small_sites(frame, maps, points)) return *std::move(sites);
  return make_general_sites(frame, maps, points);
}

std::vector<Site> make_sites(const Frame& frame, const std::vector<Vector>& points) {
  return make_sites(frame, SiteMaps(frame), points);
}

Isometry Site::from_site(const Frame& frame) const {
  if (is_large()) return form->large->from_site;
  Isometry element = frame.cosets[form->coset];
  for (int i = 0; i < frame.dimension; ++i)
    element.translation[i] += Rational(static_cast<long>(form->translation[static_cast<std::size_t>(i)]));
  return element;
}

}  // namespace flatdt::ref
