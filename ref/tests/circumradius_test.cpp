/// The largest empty ball, found with bounds in doubles, against all balls in integers.
#include "flatdt/ref/circumradius.hpp"

#include <gtest/gtest.h>

#include "flatdt/ref/families.hpp"
#include "flatdt/ref/frame_triangulation.hpp"

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

}  // namespace
}  // namespace flatdt::ref
