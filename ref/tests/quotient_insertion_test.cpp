/// Insertion on the manifold itself while its complex is not simplicial: vertices that occur twice in a cell,
/// cells with the same vertices, cells that are their own neighbours. There ids of cells and vertices
/// determine nothing, only lifts do. Here only points whose conflict region is clear of its own copies; the
/// others are in insertion_without_covers_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "flatdt/ref/delaunay_hierarchy.hpp"
#include "flatdt/ref/families.hpp"
#include "flatdt/ref/skeleton_cycles.hpp"

namespace flatdt::ref {
namespace {

/// Whether C and its copies gC, g != 1, do not overlap and share no facet, C the conflict region of a point
/// q, told from the triangulation with q: no cell has two lifts of q, and the facets opposite to q in the
/// star of q are different.
template <int D>
bool is_clear_of_its_copies(const GroupTable& table, const std::vector<CellPoints<D>>& cells, SiteId q) {
  const Subgroup whole = Subgroup::whole(table);
  std::vector<std::array<OrbitPoint, D>> opposite;
  for (const CellPoints<D>& cell : cells) {
    const auto is_q = [q](const OrbitPoint& p) { return p.site == q; };
    const auto lifts = std::count_if(cell.begin(), cell.end(), is_q);
    if (lifts > 1) return false;
    if (lifts == 0) continue;
    std::array<OrbitPoint, D> facet;
    std::remove_copy_if(cell.begin(), cell.end(), facet.begin(), is_q);
    opposite.push_back(canonical_face<D>(table, whole, facet).key);
  }
  std::sort(opposite.begin(), opposite.end());
  return std::adjacent_find(opposite.begin(), opposite.end()) == opposite.end();
}

/// Inserts the points one by one in a cover, and on the manifold those whose conflict region does not meet
/// its copies. Returns how many insertions on the manifold began in a complex that is not simplicial.
template <int D>
int compare(const Instance& instance) {
  const GroupAnalysis analysis = analyse(instance);
  const GroupTable table(analysis.frame);
  const std::vector<Site> sites = make_sites(analysis.frame, instance.points);
  const TieOrder order(analysis.frame, table);
  Predicates<D> predicates(analysis.frame, table, sites, order, PredicateStages::filtered);
  Circumradius<D> circumradius(analysis.frame, predicates);
  const Setting<D> setting{&analysis.frame, &table, &sites, &order, &predicates, &circumradius};
  const Subgroup whole = Subgroup::whole(table);
  DelaunayHierarchy<D> covered(setting,
                               Subgroup::sublattice(table, one_at_a_time_cover(analysis.frame, 20000)));
  std::optional<PeriodicDelaunay<D>> manifold;
  const auto modulo_group = [&](const QuotientComplex<D>& complex) {
    return cells_modulo<D>(table, whole, complex.all_cells(), complex.subgroup().index()).value();
  };
  int insertions = 0;
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    const SiteId q{i};
    covered.insert_orbit(q, 0);
    const std::vector<CellPoints<D>> expected = modulo_group(covered.full().complex());
    if (!manifold || !is_clear_of_its_copies<D>(table, expected, q)) {
      manifold.emplace(setting, whole);
      for (std::uint32_t k = 1; k <= i; ++k) manifold->add_site(SiteId{k});
      manifold->start(SiteId{0}, expected);
      continue;
    }
    if (find_short_cycle<D>(table, modulo_group(manifold->complex()))) ++insertions;
    const OrbitPoint near = manifold->start_near(manifold->complex().lift(OrbitPoint{q, Element{}}));
    const Location at = manifold->locate(q, Element{}, near);
    manifold->add_site(q);
    manifold->insert(q, 0, at);
    EXPECT_EQ(modulo_group(manifold->complex()), expected) << *instance.name << ", point " << i;
  }
  return insertions;
}

TEST(InsertionOnTheManifold, GoesOverLiftsWhereIdsDetermineNothing) {
  int plane = 0, space = 0;
  for (const char* name : {"torus", "klein-bottle"})
    for (std::uint64_t seed = 0; seed < 60; ++seed)
      for (const char* family : {"uniform", "grid"})
        plane += compare<2>(generate(*find_entry(name), name, family, 9, seed, "random"));
  for (const char* name : {"torocosm", "first-amphicosm"})
    space += compare<3>(generate(*find_entry(name), name, "uniform", 30, 1, "canonical"));
  EXPECT_GT(plane, 50);
  EXPECT_GT(space, 5);
  RecordProperty("plane", plane);
  RecordProperty("space", space);
}

}  // namespace
}  // namespace flatdt::ref
