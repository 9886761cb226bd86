/// Sites in machine integers against sites in rationals.
#include "small_sites.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/families.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "instance_elements.hpp"
#include "split_mix.hpp"

namespace flatdt::ref {
namespace {

TEST(SmallSites, AreTheGeneralOnes) {
  std::size_t compared = 0;
  std::uint64_t seed = 1;
  for (const CatalogueEntry& entry : catalogue())
    for (const char* family : {"uniform", "grid", "single-orbit", "far-from-cell", "skew-basis",
                               "near-cospherical", "long-cell", "on-axis"})
      for (const char* metric : {"canonical", "random"}) {
        const Instance instance = generate(entry, entry.name, family, 9, seed++, metric);
        const Frame frame = analyse(instance).frame;
        const auto small = make_small_sites(frame, SiteMaps(frame), instance.points);
        const std::vector<Site> general = make_general_sites(frame, SiteMaps(frame), instance.points);
        if (!small) continue;  // counted below
        ++compared;
        ASSERT_EQ(small->size(), general.size());
        for (std::size_t i = 0; i < general.size(); ++i) {
          const Site &s = (*small)[i], &g = general[i];
          EXPECT_EQ(s.point, g.point);
          EXPECT_EQ(s.denominator(), g.denominator());
          for (int k = 0; k < frame.dimension; ++k) {
            EXPECT_EQ(s.numerator(k), g.numerator(k));
            const auto j = static_cast<std::size_t>(k);
            const Rational error =
                Rational(mpq_class(s.approximate()[j])) - Rational(s.numerator(k), s.denominator());
            EXPECT_LT(abs(error) * Rational(Integer(1L << 51U)), Rational(1));
          }
          EXPECT_EQ(s.from_site(frame), g.from_site(frame)) << entry.name << " " << family;
        }
      }
  // Of 192; the others have numbers beyond the range (far from the cell by up to 2^50, bases of many digits).
  EXPECT_GT(compared, 140U);
}

TEST(SmallSites, LeaveWhatDoesNotFitToRationals) {
  const std::string head = "flatdt-instance 1\ndimension 2\nmanifold torus\nmetric 1 0 1\npoints 1\n";
  for (const auto& [point, fits] : std::vector<std::pair<std::string, bool>>{
           {"1/4611686018427387903 0", true},     // 2^62 - 1
           {"1/4611686018427387904 0", false},    // 2^62
           {"1/3037000500 1/3037000499", false},  // whose product is above
           {"2147483647 0", true},
           {"2147483648 0", false},
           {"100000000000000000000 0", false}}) {
    const Instance instance = parse_instance(head + point + "\n", "test");
    const Frame frame = analyse(instance).frame;
    EXPECT_EQ(make_small_sites(frame, SiteMaps(frame), instance.points).has_value(), fits) << point;
  }
}

/// Numbers of the points that are long, and elements of theirs that are not, or only some: an element in
/// machine integers is the one in rationals.
TEST(InstanceElements, AreTheSameInMachineIntegers) {
  SplitMix64 random(1);
  std::size_t small = 0, large = 0;
  const Rational tiny(Integer(1), Integer(std::string("1267650600228229401496703205653")));
  for (const CatalogueEntry& entry : catalogue())
    for (const char* far : {"0", "-17", "281474976710", "1000000000000000000000"})
      for (const char* family : {"uniform", "skew-basis"}) {
        Instance instance = generate(entry, entry.name, family, 5, random.next(), "random");
        for (Vector& p : instance.points) p[0] += tiny;
        instance.points.back()[1] += Rational(Integer(std::string(far)));
        const PreparedGroup group(analyse(instance));
        const std::vector<Site> sites = make_sites(group.frame(), instance.points);
        ASSERT_TRUE(sites[0].is_large()) << entry.name;
        const InstanceElements elements(group, sites);
        for (int round = 0; round < 20; ++round) {
          const auto below = [&random](std::size_t n) {
            return static_cast<std::uint32_t>(random.next() % n);
          };
          OrbitPoint p{SiteId{below(sites.size())}, Element{}};
          p.g.coset = static_cast<std::uint16_t>(below(group.frame().cosets.size()));
          for (std::size_t i = 0; i < static_cast<std::size_t>(entry.dimension); ++i)
            p.g.t[i] = static_cast<std::int16_t>(below(11));
          const auto in_frame = elements.in_frame(p);
          ++(in_frame ? small : large);
          if (!in_frame) continue;
          EXPECT_EQ(group.in_instance(in_frame->coset, in_frame->translation), elements.at(p)) << entry.name;
        }
      }
  EXPECT_GT(small, 500U);
  EXPECT_GT(large, 100U);
}

}  // namespace
}  // namespace flatdt::ref
