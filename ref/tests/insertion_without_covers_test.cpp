/// Insertion without covers (docs/theory.md, section 7) against the covering engine, whose answer is a
/// function of the instance too: the same bytes, whichever way the star of a new point is found.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "flatdt/ref/families.hpp"
#include "flatdt/ref/first_orbit.hpp"
#include "flatdt/ref/frame_triangulation.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"

namespace flatdt::ref {
namespace {

std::string bytes(const Instance& instance, Insertion insertion, std::size_t region_limit = kRegionLimit,
                  std::uint64_t order_seed = 0) {
  TriangulationOptions options;
  options.insertion = insertion;
  options.region_limit = region_limit;
  options.order_seed = order_seed;
  const TriangulationResult result = triangulate(instance, analyse(instance), options);
  EXPECT_EQ(result.working_cover.has_value(), insertion == Insertion::covering);
  return write_triangulation(result.triangulation, describe(result));
}

class EveryManifold : public testing::TestWithParam<std::string> {};

TEST_P(EveryManifold, TheEnginesAgree) {
  const CatalogueEntry& entry = *find_entry(GetParam());
  const std::vector<long> sizes =
      entry.dimension == 2 ? std::vector<long>{1, 2, 5, 20} : std::vector<long>{1, 2, 3};
  std::uint64_t seed = 17;
  for (const char* family : {"uniform", "grid", "cospherical", "on-axis"})
    for (const long n : sizes) {
      ++seed;
      const Instance instance =
          generate(entry, entry.name, family, n, seed, seed % 2 == 0 ? "canonical" : "random");
      const std::string searched = bytes(instance, Insertion::without_covers);
      EXPECT_EQ(searched, bytes(instance, Insertion::without_covers, 0))
          << "long-lattice form: " << entry.name << " " << family << " " << n << "\n"
          << write_instance(instance);
      // In space covers of many sheets are slow: one family, and triangulate_test has two more.
      if (entry.dimension == 3 && (n != 2 || std::string_view(family) != "cospherical")) continue;
      EXPECT_EQ(searched, bytes(instance, Insertion::covering))
          << "covering: " << entry.name << " " << family << " " << n << "\n"
          << write_instance(instance);
    }
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const CatalogueEntry& entry : catalogue()) result.push_back(entry.name);
  return result;
}
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryManifold, testing::ValuesIn(names()), [](const auto& tested) {
  std::string name = tested.param;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
});

/// Points of the didicosm in general position need no order within orbits; a grid does. Whether the insertion
/// stopped is asked of the level itself: the answer is the same.
bool is_inserted_by_rank(const Instance& instance) {
  const PreparedGroup group(analyse(instance));
  const std::vector<Site> sites = make_sites(group.frame(), instance.points);
  Predicates<3> predicates(group.frame(), group.table(), sites, group.order(), PredicateStages::filtered);
  Circumradius<3> circumradius(group.frame(), predicates);
  const Setting<3> setting{&group.frame(), &group.table(), &sites,
                           &group.order(), &predicates,    &circumradius};
  PeriodicDelaunay<3> level(setting, Subgroup::whole(group.table()), Insertion::without_covers);
  level.start(SiteId{0}, triangulate_first_orbit<3>(group.frame(), group.table(), sites, group.order(),
                                                    predicates, SiteId{0}));
  for (std::uint32_t i = 1; i < sites.size() && !level.needs_smaller_group(); ++i) {
    level.add_site(SiteId{i});
    level.insert(SiteId{i}, 0, level.locate(SiteId{i}, {}, {SiteId{i - 1}, {}}));
  }
  return !level.needs_smaller_group();
}

TEST(Didicosm, RanksDecideUnlessOrbitsTieWithinThemselves) {
  const CatalogueEntry& entry = *find_entry("didicosm");
  int by_rank = 0;
  int not_by_rank = 0;
  for (const char* family : {"uniform", "grid", "cospherical", "on-axis", "clustered"})
    for (const long n : {2L, 5L, 12L, 40L}) {
      const Instance instance = generate(entry, entry.name, family, n, static_cast<std::uint64_t>(n) + 3,
                                         n == 5 ? "random" : "canonical");
      ++(is_inserted_by_rank(instance) ? by_rank : not_by_rank);
      const PreparedGroup group(analyse(instance));
      TriangulationOptions modulo_the_subgroup;
      modulo_the_subgroup.order = InsertionOrder::random;
      EXPECT_EQ(triangulate_in_frame<3>(instance.points, group, {}).cells,
                triangulate_in_frame<3>(instance.points, group, modulo_the_subgroup).cells)
          << family << " " << n;
    }
  EXPECT_TRUE(is_inserted_by_rank(generate(entry, entry.name, "uniform", 60, 1)));
  EXPECT_GT(by_rank, 3);
  EXPECT_GT(not_by_rank, 3);
}

/// The regions of the second point and its copies only touch, and overlaps alone would give a tiling that is
/// not Delaunay (INSERTION 3).
TEST(OwnCopies, RegionsThatOnlyTouch) {
  const Instance instance = parse_instance(
      "flatdt-instance 1\ndimension 2\nmanifold torus\nmetric 1 1/5 1\npoints 2\n0 0\n3/5 3/10\n", "touch");
  EXPECT_EQ(bytes(instance, Insertion::without_covers), bytes(instance, Insertion::covering));
  EXPECT_EQ(bytes(instance, Insertion::without_covers, 0), bytes(instance, Insertion::covering));
}

/// An aspect ratio that no cover of copies inserted one at a time could hold, and regions of millions of
/// lifts.
TEST(LongLattices, AreNoLimit) {
  for (const char* metric : {"1 0 0 1 0 1000000000000", "1 0 0 1000000 0 1000000000000",
                             "1 1/3 1/7 1000001/7 5/9 999999999999/11"}) {
    const Instance instance =
        parse_instance("flatdt-instance 1\ndimension 3\nmanifold torocosm\nmetric " + std::string(metric) +
                           "\npoints 4\n1/10 1/5 1/3\n3/4 3/8 1/5\n2/5 9/10 7/10\n1/3 1/7 1/9\n",
                       "long");
    EXPECT_EQ(bytes(instance, Insertion::without_covers, kRegionLimit, 1),
              bytes(instance, Insertion::without_covers, 0, 2))
        << metric;
  }
}

/// Cells so flat that their centres in doubles lie 10^5 lattice vectors off.
TEST(LongLattices, WalksStayNear) {
  for (const char* name : {"long-lattice-flat-cell", "long-lattice-four-points"}) {
    std::ifstream in(std::string(FLATDT_CORPORA "/regressions/") + name + ".instance");
    ASSERT_TRUE(in) << name;
    const Instance instance = parse_instance(std::string(std::istreambuf_iterator<char>(in), {}), name);
    std::set<std::string> answers;
    for (const std::uint64_t seed : {0, 1, 2, 3})
      answers.insert(bytes(instance, Insertion::without_covers, kRegionLimit, seed));
    EXPECT_EQ(answers.size(), 1U) << name;
  }
}

/// Of few points, so that some cells of the star are left with copies of the new point alone (the hexacosm's
/// with seed 5 is in conflict with a vertex that is not the nearest in coordinates).
TEST(LongLattices, CellsOfCopiesAlone) {
  for (const char* name : {"dicosm", "tetracosm", "hexacosm"})
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
      const Instance instance = generate(*find_entry(name), name, "long-cell", 2, seed, "random");
      EXPECT_EQ(bytes(instance, Insertion::without_covers, kRegionLimit, 0),
                bytes(instance, Insertion::without_covers, 0, 1))
          << name << " " << seed;
    }
}

/// On lattices 1:6 a cover still fits: all three ways agree.
TEST(LongLattices, AgreeWithTheCoveringEngine) {
  const Instance tall = parse_instance(
      "flatdt-instance 1\ndimension 3\nmanifold torocosm\nmetric 1 0 0 1 0 36\npoints 3\n0 0 0\n1/2 1/3 "
      "1/5\n"
      "1/7 1/2 3/4\n",
      "tall");
  const std::string covering = bytes(tall, Insertion::covering);
  EXPECT_EQ(bytes(tall, Insertion::without_covers), covering);
  EXPECT_EQ(bytes(tall, Insertion::without_covers, 0), covering);
}

}  // namespace
}  // namespace flatdt::ref
