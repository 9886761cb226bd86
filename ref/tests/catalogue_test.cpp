/// The catalogue against itself and against a recomputation from its generators.
#include "flatdt/ref/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "group_samples.hpp"

namespace flatdt::ref::testing {
namespace {

TEST(Catalogue, HasTwelveManifoldsWithDistinctNames) {
  std::set<std::string> names;
  std::size_t count = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    names.insert(entry.name);
    names.insert(entry.aliases.begin(), entry.aliases.end());
    count += 1 + entry.aliases.size();
    EXPECT_EQ(find_entry(entry.name), &entry);
    for (const std::string& alias : entry.aliases) EXPECT_EQ(find_entry(alias), &entry);
    for (const std::string& alias : entry.mirror_aliases) EXPECT_EQ(find_entry(alias), &entry);
  }
  EXPECT_EQ(catalogue().size(), 12U);
  EXPECT_EQ(names.size(), count);
  for (const char* name : {"", "Torus", "p2", "G7", "g1", "P31 (no. 144)"})
    EXPECT_EQ(find_entry(name), nullptr);
}

TEST(Catalogue, OnlyThreeEntriesHaveAMirrorImage) {
  for (const CatalogueEntry& entry : catalogue()) {
    const bool chiral = entry.name == "tricosm" || entry.name == "tetracosm" || entry.name == "hexacosm";
    EXPECT_EQ(!entry.mirror_image_generators.empty(), chiral);
    EXPECT_EQ(entry.mirror_aliases.size(), chiral ? 1U : 0U);
    EXPECT_EQ(entry.space_groups.size(), chiral ? 2U : 1U);
    EXPECT_EQ(&generators_of(entry, entry.name), &entry.generators);
    for (const std::string& alias : entry.mirror_aliases)
      EXPECT_EQ(&generators_of(entry, alias), &entry.mirror_image_generators);
  }
  EXPECT_EQ(find_entry("P32")->mirror_aliases[0], "P32");
  EXPECT_EQ(find_entry("P43")->mirror_aliases[0], "P43");
  EXPECT_EQ(find_entry("P65")->mirror_aliases[0], "P65");
}

/// z -> -z reverses the orientation and preserves the canonical metrics.
TEST(Catalogue, AMirrorImageIsOne) {
  const Isometry reflection{make_matrix(3, {1, 0, 0, 0, 1, 0, 0, 0, -1}), Vector(3)};
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.mirror_image_generators.empty()) continue;
    std::vector<Isometry> reflected;
    for (const Isometry& g : entry.generators) reflected.push_back(reflection * g * reflection);
    const GroupAnalysis image = analyse(make_instance(reflected, entry.canonical_gram));
    const GroupAnalysis listed = analyse(make_instance(entry.mirror_image_generators, entry.canonical_gram));
    EXPECT_EQ(image.cosets, listed.cosets);
    EXPECT_EQ(image.lattice, listed.lattice);
    EXPECT_TRUE(listed.frame.mirrored);
    EXPECT_TRUE(listed.frame.to_catalogue.is_identity());
  }
}

TEST(Catalogue, EverythingFollowsFromTheGenerators) {
  for (const CatalogueEntry& entry : catalogue()) {
    const GroupAnalysis analysis = analyse(make_instance(entry.generators, entry.canonical_gram));
    EXPECT_EQ(analysis.entry, &entry);
    EXPECT_EQ(analysis.h1, entry.h1);
    EXPECT_EQ(analysis.orientable, entry.orientable);
    EXPECT_EQ(analysis.holonomy_order, entry.holonomy_order);
    EXPECT_TRUE(analysis.lattice.is_identity());
    EXPECT_EQ(analysis.frame.delta_squared, entry.canonical_delta_squared);
    EXPECT_FALSE(analysis.frame.mirrored);
    EXPECT_TRUE((analysis.frame.basis * analysis.frame.to_catalogue.inverse()).is_identity());
    EXPECT_TRUE(analysis.frame.origin.is_zero());
    expect_frame_holds(analysis, entry.canonical_gram);

    std::vector<Isometry> listed = entry.coset_representatives, computed = analysis.cosets;
    EXPECT_TRUE(listed[0].is_identity());
    std::sort(listed.begin(), listed.end());
    std::sort(computed.begin(), computed.end());
    EXPECT_EQ(listed, computed);
  }
}

TEST(Catalogue, InvariantsSeparateTheEntries) {
  for (const CatalogueEntry& a : catalogue())
    for (const CatalogueEntry& b : catalogue())
      EXPECT_EQ(&a == &b, a.dimension == b.dimension && a.orientable == b.orientable &&
                              a.holonomy == b.holonomy && a.h1 == b.h1);
}

/// g = {R|t} is positive iff t is lexicographically positive in these coordinates; the order is a left order
/// iff no element is neither, so iff t never vanishes for R other than the identity.
TEST(Catalogue, LeftOrderCoordinates) {
  for (const CatalogueEntry& entry : catalogue()) {
    EXPECT_EQ(entry.left_order_coordinates,
              entry.dimension == 2 ? std::vector<int>({1, 0}) : std::vector<int>({2, 0, 1}));
    EXPECT_EQ(entry.left_orderable, entry.name != "didicosm");
    if (!entry.left_orderable) continue;
    // Positivity of a product of positive elements: the last row of R is that of the identity, and where the
    // first coordinate of the order vanishes, the next one is preserved as well.
    for (const Isometry& g : entry.coset_representatives) {
      const int last = entry.dimension - 1;
      for (int j = 0; j < entry.dimension; ++j) EXPECT_EQ(g.linear(last, j), Rational(j == last ? 1 : 0));
      if (g.linear.is_identity() || !g.translation[last].is_zero()) continue;
      EXPECT_EQ(g.linear(0, 0), Rational(1)) << entry.name;
      EXPECT_FALSE(g.translation[0].is_zero()) << entry.name;
    }
  }
}

}  // namespace
}  // namespace flatdt::ref::testing
