/// Sites in machine integers against sites in rationals.
#include "small_sites.hpp"

#include <gtest/gtest.h>

#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/families.hpp"
#include "flatdt/ref/instance_format.hpp"

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

}  // namespace
}  // namespace flatdt::ref
