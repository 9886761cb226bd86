/// The order of a batch, and the elements as cells keep them.
#include "flatdt/ref/insertion_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flatdt/ref/element_store.hpp"
#include "flatdt/ref/families.hpp"

namespace flatdt::ref {
namespace {

TEST(BatchOrder, IsAPermutation) {
  for (const char* manifold : {"torus", "klein-bottle", "3-torus", "didicosm"})
    for (const long n : {1L, 2L, 63L, 64L, 65L, 1000L}) {
      const Instance instance = generate(*find_entry(manifold), manifold, "uniform", n, 5, "random");
      const Frame frame = analyse(instance).frame;
      const std::vector<Site> sites = make_sites(frame, instance.points);
      std::vector<SiteId> order = batch_order(frame, sites, 1);
      EXPECT_EQ(order, batch_order(frame, sites, 1));
      if (n >= 63) {
        EXPECT_NE(order, batch_order(frame, sites, 2));
      }
      std::sort(order.begin(), order.end());
      ASSERT_EQ(order.size(), sites.size());
      for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(index_of(order[i]), i);
    }
}

/// On a full grid the last round's steps along the curve are short: on Hilbert's curve through all points of
/// a grid each step has length 1; a round misses one of eight.
TEST(BatchOrder, FollowsTheCurve) {
  const Instance instance = generate(*find_entry("3-torus"), "3-torus", "grid", 4096, 3, "canonical");
  const Frame frame = analyse(instance).frame;
  const std::vector<Site> sites = make_sites(frame, instance.points);
  const std::vector<SiteId> order = batch_order(frame, sites, 7);
  double total = 0;
  for (std::size_t i = 513; i < order.size(); ++i) {
    const auto a = sites[index_of(order[i - 1])].approximate(), b = sites[index_of(order[i])].approximate();
    total += 16 * std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                            (a[2] - b[2]) * (a[2] - b[2]));
  }
  // Measured: 1.10. In the order of the sites, which is lexicographic, 1.9; in random order 10.6.
  EXPECT_LT(total / static_cast<double>(order.size() - 513), 1.2);
}

TEST(ElementStore, GivesBackEveryElement) {
  ElementStore store;
  std::size_t numbered = 0;
  for (int x = -10; x <= 10; ++x)
    for (int y = -10; y <= 10; ++y)
      for (int z = -10; z <= 10; ++z)
        for (const std::uint16_t coset : {0, 3, 5}) {
          const Element g{
              {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)},
              coset};
          const ElementStore::Code code = store.code(g);
          if (code >= 0x8000) ++numbered;
          EXPECT_EQ(store[code], g);
          EXPECT_EQ(store.code(g), code);
        }
  EXPECT_EQ(numbered, 3U * (21 * 21 * 21 - 16 * 16 * 16));
  const Element far{{32767, -32767, 32767}, 2};
  EXPECT_EQ(store[store.code(far)], far);
}

TEST(ElementStore, HasALimitThatIsAnError) {
  ElementStore store;
  for (int x = 0; x < 32768; ++x)
    static_cast<void>(store.code({{static_cast<std::int16_t>(x - 16384), 100, 0}, 0}));
  EXPECT_THROW(static_cast<void>(store.code({{0, 101, 0}, 0})), LimitReached);
  EXPECT_EQ(store[store.code({{5, 100, 0}, 0})], (Element{{5, 100, 0}, 0}));
}

}  // namespace
}  // namespace flatdt::ref
