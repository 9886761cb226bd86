#include "cases.hpp"

#include <algorithm>

#include "point_families.hpp"

namespace flatdt::campaign {
namespace {

using testing::Random;
using testing::Specimen;

// Bounds on cost: cells much longer than wide take the reference seconds.
constexpr long kMaxStretchInPlane = 20;
constexpr long kMaxStretchInSpace = 4;

int bits(long n) {
  int count = 0;
  for (; n > 1; n /= 2) ++count;
  return count;
}

/// In [low, high], each power of two as likely as the next.
long number_of_points(long low, long high, Random& random) {
  const long exponent = random.between(bits(low), bits(high));
  return random.between(std::max(low, 1L << exponent), std::min(high, (2L << exponent) - 1));
}

bool is_own(const std::string& family) {
  const auto& own = own_families();
  return std::find(own.begin(), own.end(), family) != own.end();
}

}  // namespace

std::vector<std::string> all_families() {
  std::vector<std::string> families = testing::point_rules();
  families.insert(families.end(), own_families().begin(), own_families().end());
  return families;
}

Specimen draw_case(const Plan& plan, std::uint64_t number) {
  // The seed and the number are mixed apart, so that neighbours of either have nothing in common.
  Random random(testing::SplitMix64(plan.seed).next() ^ testing::SplitMix64(~number).next());
  const std::string family = random.of(plan.families);
  const long n = number_of_points(plan.min_points, plan.max_points, random);
  testing::Domain domain;
  domain.manifolds = {random.of(plan.manifolds)};
  domain.rules = {is_own(family) ? "uniform" : family};
  domain.min_points = domain.max_points_in_plane = domain.max_points_in_space = n;
  domain.max_stretch_in_plane = kMaxStretchInPlane;
  domain.max_stretch_in_space = kMaxStretchInSpace;
  Specimen specimen = testing::draw_specimen(domain, random.next(), 100);
  specimen.family = family;
  specimen.choice = 0;
  if (is_own(family)) specimen.points = draw_points(family, specimen.dimension(), n, random);
  return conform(plan.capabilities, std::move(specimen));
}

testing::Domain shrinking_domain(const Plan& plan) {
  testing::Domain domain;
  for (const std::string& name : plan.manifolds) {
    Specimen s = testing::empty_specimen(name);
    Capabilities any_number = plan.capabilities;
    any_number.min_points = 0;
    if (accepts(any_number, conform(any_number, s))) domain.manifolds.push_back(testing::name_of(s));
  }
  // Shrunk cases are never larger than the case.
  domain.max_points_in_plane = domain.max_points_in_space = plan.max_points;
  domain.max_stretch_in_plane = kMaxStretchInPlane;
  domain.max_stretch_in_space = kMaxStretchInSpace;
  return domain;
}

}  // namespace flatdt::campaign
