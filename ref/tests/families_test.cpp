/// Every family on every manifold: counts, determinism, admissibility, arguments.
#include <set>

#include "families_fixture.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::ref {
namespace {

TEST_P(EveryManifold, EveryFamilyIsAdmissibleAndDeterministic) {
  for (const Family& family : families()) {
    for (const char* metric : {"canonical", "random"}) {
      for (const long n : {1L, 2L, 12L}) {
        SCOPED_TRACE(family.name + " " + metric + " " + std::to_string(n));
        const Instance instance = make(family.name, n, 7, metric);
        ASSERT_EQ(instance.points.size(), static_cast<std::size_t>(n));
        const std::string text = write_instance(instance);
        EXPECT_EQ(write_instance(parse_instance(text, "generated")), text);
        EXPECT_EQ(write_instance(make(family.name, n, 7, metric)), text);
        const GroupAnalysis analysis = analyse(instance);
        EXPECT_EQ(analysis.entry->name, entry().name);
        if (family.name == "single-orbit") continue;
        for (std::size_t i = 0; i < instance.points.size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(equivalent(analysis.cosets, instance.points[i], instance.points[j]));
      }
    }
  }
}

TEST_P(EveryManifold, SeedsMatter) {
  for (const Family& family : families())
    EXPECT_NE(write_instance(make(family.name, 5, 1)), write_instance(make(family.name, 5, 2)))
        << family.name;
}

TEST_P(EveryManifold, RandomMetricsAreModerateAndVary) {
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Matrix gram = make("uniform", 1, seed, "random").gram;
    EXPECT_TRUE(is_positive_definite(gram));
    seen.insert(gram.to_string());
    for (int i = 0; i < gram.dimension(); ++i)
      for (int j = 0; j < gram.dimension(); ++j) EXPECT_LE(gram(i, i), Rational(4) * gram(j, j));
  }
  EXPECT_GE(seen.size(), 15U);
}

INSTANTIATE_TEST_SUITE_P(Families, EveryManifold, testing::ValuesIn(manifold_names()), test_name);

TEST(Families, MirrorImageNames) {
  for (const char* name : {"P32", "P43", "P65"}) {
    const CatalogueEntry& entry = *find_entry(name);
    for (const Family& family : families()) {
      const Instance instance = generate(entry, name, family.name, 4, 3);
      EXPECT_EQ(instance.name, name);
      EXPECT_EQ(analyse(instance).entry->name, entry.name) << family.name;
    }
  }
}

TEST(Families, RefusesBadArguments) {
  const CatalogueEntry& entry = *find_entry("torus");
  EXPECT_THROW(generate(entry, "torus", "unifrom", 1, 0), InvalidInput);
  EXPECT_THROW(generate(entry, "torus", "uniform", 0, 0), InvalidInput);
  EXPECT_THROW(generate(entry, "torus", "uniform", -3, 0), InvalidInput);
  EXPECT_THROW(generate(entry, "torus", "uniform", kMaxGeneratedPoints + 1, 0), InvalidInput);
  EXPECT_THROW(generate(entry, "torus", "uniform", 1, 0, "skew"), InvalidInput);
}

TEST(Families, SameBytesOnEveryMachine) {
  EXPECT_EQ(write_instance(generate(*find_entry("klein-bottle"), "pg", "uniform", 2, 1, "random")),
            "flatdt-instance 1\ndimension 2\nmanifold pg\nmetric 9/4 0 121/64\npoints 2\n"
            "  309149/1048576 627839/1048576\n  426817/1048576 56465/262144\n");
}

/// FNV-1a of all families on all manifolds: an expression with two draws would give each compiler its own.
TEST(Families, SameBytesWithEveryCompiler) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const std::string& name : manifold_names())
    for (const Family& family : families())
      for (const char* metric : {"canonical", "random"})
        for (const char c : write_instance(generate(*find_entry(name), name, family.name, 20, 5, metric)))
          hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  EXPECT_EQ(hash, 12074922538880052782U);
}

}  // namespace
}  // namespace flatdt::ref
