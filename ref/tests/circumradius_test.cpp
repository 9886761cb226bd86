/// The largest empty ball, found with bounds in doubles, against all balls in integers.
#include "flatdt/ref/circumradius.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "flatdt/ref/families.hpp"
#include "flatdt/ref/frame_triangulation.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::ref {
namespace {

template <int D>
void compare(const Instance& instance) {
  const PreparedGroup group(analyse(instance));
  const auto answer = triangulate_in_frame<D>(instance.points, group, {});
  ExactPredicates<D> exact(group.frame(), group.table(), answer.sites);
  Rational largest;
  for (const CellPoints<D>& cell : answer.cells) {
    const auto [numerator, denominator] = exact.squared_circumradius(cell);
    largest = std::max(largest, Rational(Integer(4) * numerator, denominator));
  }
  EXPECT_EQ(empty_diameter_squared<D>(answer, group), largest);
}

TEST(Circumradius, LargestOfAllCells) {
  std::uint64_t seed = 1;
  for (const CatalogueEntry& entry : catalogue())
    for (const char* family :
         {"uniform", "grid", "near-cospherical", "clustered", "nearly-duplicate", "long-cell"})
      for (const char* metric : {"canonical", "random"}) {
        const Instance instance =
            generate(entry, entry.name, family, entry.dimension == 2 ? 30 : 12, seed++, metric);
        SCOPED_TRACE(entry.name + " " + family + " " + metric);
        if (entry.dimension == 2)
          compare<2>(instance);
        else
          compare<3>(instance);
      }
}

/// Where squared lengths, their products or determinants leave the range of doubles.
TEST(Circumradius, MetricsAtTheEndsOfDoubles) {
  for (const CatalogueEntry& entry : catalogue())
    for (const int exponent : {-1060, -360, -180, 240, 360, 540, 1060}) {
      Instance instance = generate(entry, entry.name, "uniform", 2, 1, "random");
      const mpq_class power(mpz_class(1) << static_cast<unsigned>(std::abs(exponent)));
      instance.gram = Rational(exponent < 0 ? mpq_class(1 / power) : power) * instance.gram;
      SCOPED_TRACE(entry.name + ", metric times 2^" + std::to_string(exponent));
      if (entry.dimension == 2)
        compare<2>(instance);
      else
        compare<3>(instance);
    }
}

TEST(Circumradius, BoundsThatAreNoNumbers) {
  std::ifstream in(FLATDT_CORPORA "/regressions/metric-times-2-to-the-360.instance");
  ASSERT_TRUE(in);
  compare<3>(parse_instance(std::string(std::istreambuf_iterator<char>(in), {}), "regression"));
}

}  // namespace
}  // namespace flatdt::ref
