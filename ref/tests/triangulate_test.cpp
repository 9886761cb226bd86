/// The algorithm of Section 4 as a whole: its answer is a function of the points of E^d/G alone.
#include "flatdt/ref/triangulate.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "flatdt/ref/delaunay_hierarchy.hpp"
#include "flatdt/ref/families.hpp"
#include "flatdt/ref/first_orbit.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/skeleton_cycles.hpp"

namespace flatdt::ref {
namespace {

Instance make(const std::string& manifold, const char* family, long n, std::uint64_t seed,
              const char* metric = "canonical") {
  return generate(*find_entry(manifold), manifold, family, n, seed, metric);
}

Instance load(const std::string& name) {
  std::ifstream file(std::string(FLATDT_CORPORA) + "/adversarial/" + name + ".instance");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_FALSE(text.str().empty()) << name;
  return parse_instance(text.str(), name);
}

TriangulationResult solve(const Instance& instance, const TriangulationOptions& options = {}) {
  return triangulate(instance, analyse(instance), options);
}

std::string bytes(const Instance& instance, const TriangulationOptions& options = {}) {
  const TriangulationResult result = solve(instance, options);
  return write_triangulation(result.triangulation, describe(result));
}

/// Cells as sets of exact points modulo the subgroup's translations are awkward to compare; points of orbit
/// representatives' stars are not: all cells as sorted lists of positions, each moved by every subgroup
/// element that brings a vertex to its point's position. Enough to compare answers for one instance given in
/// different ways.
std::multiset<std::string> stars(const Instance& instance, const Triangulation& t) {
  std::multiset<std::string> result;
  std::vector<Isometry> inverses;
  for (const Isometry& g : t.elements) inverses.push_back(g.inverse());
  for (const auto& cell : t.cells) {
    for (int k = 0; k <= t.dimension; ++k) {
      const auto& pivot = cell[static_cast<std::size_t>(k)];
      const Isometry& back = inverses[pivot.element];
      std::vector<Vector> positions;
      for (int j = 0; j <= t.dimension; ++j) {
        const auto& v = cell[static_cast<std::size_t>(j)];
        positions.push_back(back * (t.elements[v.element] * instance.points[v.point]));
      }
      std::sort(positions.begin(), positions.end());
      std::string text = std::to_string(pivot.point) + ":";
      for (const Vector& x : positions) text += " (" + x.to_string() + ")";
      result.insert(text);
    }
  }
  return result;
}

TEST(Triangulate, BytesDoNotDependOnOrderCoverOrStage) {
  std::uint64_t seed = 1;
  for (const CatalogueEntry& entry : catalogue()) {
    for (const char* family : {"uniform", "grid"}) {
      const Instance instance = make(entry.name, family, entry.dimension == 2 ? 12 : 3, seed++);
      const std::string expected = bytes(instance);
      TriangulationOptions covering;
      covering.insertion = Insertion::covering;
      EXPECT_EQ(bytes(instance, covering), expected) << entry.name << " " << family;
      for (const std::uint64_t order : {1U, 2U}) {
        TriangulationOptions options;
        options.order_seed = order;
        EXPECT_EQ(bytes(instance, options), expected) << entry.name << " " << family;
      }
      for (const PredicateStages stages :
           {PredicateStages::filter_only, PredicateStages::fixed_only, PredicateStages::exact_only}) {
        TriangulationOptions options;
        options.stages = stages;
        EXPECT_EQ(bytes(instance, options), expected) << entry.name << " " << family;
      }
      TriangulationOptions one_by_one;
      one_by_one.order = InsertionOrder::random;
      EXPECT_EQ(bytes(instance, one_by_one), expected) << entry.name << " " << family;
      TriangulationOptions theorem10;
      theorem10.insertion = Insertion::covering;
      theorem10.cover = CoverChoice::theorem10;
      if (entry.holonomy_order <= 2) {
        EXPECT_EQ(bytes(instance, theorem10), expected) << entry.name << " " << family;
      }
    }
  }
}

TEST(Triangulate, DoesNotDependOnRepresentativesOrFileOrder) {
  std::uint64_t seed = 50;
  for (const CatalogueEntry& entry : catalogue()) {
    for (const char* family : {"grid", "cospherical"}) {
      if (entry.dimension == 3 && std::string(family) == "cospherical")
        continue;  // covers are slow to compare
      const Instance instance = make(entry.name, family, 3, seed++);
      const TriangulationResult expected = solve(instance);
      // Other representatives of the same orbits.
      Instance moved = instance;
      const Isometry& g = instance.generators.back();
      const Isometry& h = instance.generators.front();
      moved.points[0] = g * (h * moved.points[0]);
      moved.points[1] = h.inverse() * (g.inverse() * moved.points[1]);
      const TriangulationResult from_moved = solve(moved);
      ASSERT_EQ(from_moved.sheets, expected.sheets) << entry.name << " " << family;
      Triangulation back = from_moved.triangulation;
      // Express the moved answer in the original points: p'_0 = g h p_0, p'_1 = h^-1 g^-1 p_1.
      std::vector<Isometry> elements;
      for (auto& cell : back.cells)
        for (int k = 0; k <= entry.dimension; ++k) {
          auto& v = cell[static_cast<std::size_t>(k)];
          // Element 3 e + i of the new list is for point i.
          v.element = 3 * v.element + v.point;
        }
      for (const Isometry& e : back.elements) {
        elements.push_back(e * g * h);
        elements.push_back(e * h.inverse() * g.inverse());
        elements.push_back(e);
      }
      back.elements = elements;
      EXPECT_EQ(stars(instance, back), stars(instance, expected.triangulation))
          << entry.name << " " << family;
      // Another order in the file.
      Instance reversed = instance;
      std::reverse(reversed.points.begin(), reversed.points.end());
      TriangulationResult from_reversed = solve(reversed);
      for (auto& cell : from_reversed.triangulation.cells)
        for (auto& v : cell) v.point = 2 - v.point;
      EXPECT_EQ(stars(instance, from_reversed.triangulation), stars(instance, expected.triangulation))
          << entry.name << " " << family;
      // A point given twice is one point of the manifold, known by the smaller index.
      Instance doubled = instance;
      doubled.points.push_back(g * doubled.points[2]);
      const TriangulationResult from_doubled = solve(doubled);
      EXPECT_EQ(from_doubled.distinct_points, 3U);
      EXPECT_EQ(write_triangulation(from_doubled.triangulation, {}),
                write_triangulation(expected.triangulation, {}));
    }
  }
}

struct Outcome {
  const char* name;
  long sheets;
  std::optional<StayedInCover::Kind> reason;
  bool switched;
};

TEST(Triangulate, InstancesThatSeparateRightFromWrong) {
  using Kind = StayedInCover::Kind;
  const std::vector<Outcome> outcomes{
      {"t2-near-tight", 9, Kind::two_cycle, false},     // switching at diameter < delta is wrong
      {"t2-checkerboard", 9, Kind::two_cycle, false},   // Delta = delta/2 exactly: strict inequality
      {"t2-third-grid", 1, std::nullopt, true},         // Delta < delta/2, all ties
      {"t2-tie-dependent", 9, Kind::two_cycle, false},  // for this tie-break
      {"t2-two-generic", 9, Kind::loop, false},
      {"k2-origin", 18, Kind::loop, false},         // lexicographic diagonals are not glide-invariant
      {"k2-yes-nohalf", 1, std::nullopt, false},    // Corollary 9 silent, the end-of-run test converts
      {"g3-origin", 63, Kind::loop, false},         // lexicographic ties are not screw-invariant
      {"g6-boxes", 108, Kind::loop, false},         // no left order
      {"g6-prisms", 108, Kind::loop, false},        // no left order
      {"t3-halfgrid", 27, Kind::two_cycle, false},  // Delta < delta, but 2-cycles
  };
  for (const Outcome& outcome : outcomes) {
    TriangulationOptions covering;
    covering.insertion = Insertion::covering;
    const TriangulationResult result = solve(load(outcome.name), covering);
    EXPECT_EQ(bytes(load(outcome.name)), write_triangulation(result.triangulation, describe(result)))
        << outcome.name << ": the engines differ";
    EXPECT_EQ(result.sheets, outcome.sheets) << outcome.name;
    EXPECT_EQ(result.switched_after.has_value(), outcome.switched) << outcome.name;
    ASSERT_EQ(result.reason.has_value(), outcome.reason.has_value()) << outcome.name;
    if (result.reason) {
      EXPECT_EQ(result.reason->kind, *outcome.reason) << outcome.name;
    }
  }
  EXPECT_EQ(solve(load("t2-checkerboard")).empty_diameter_squared, Rational(Integer(1), Integer(4)));
  const TriangulationResult tight = solve(load("t2-near-tight"));
  EXPECT_LT(tight.empty_diameter_squared, tight.delta_squared);  // below delta, yet a 2-cycle
  EXPECT_GT(Rational(4) * tight.empty_diameter_squared, tight.delta_squared);
}

/// An edge or 2-cycle that is given as the reason really is in the cover that is written.
TEST(Triangulate, TheReasonIsAWitness) {
  for (const char* manifold : {"torus", "klein-bottle", "dicosm", "didicosm", "first-amphicosm"}) {
    const Instance instance = make(manifold, "uniform", 2, 9);
    const TriangulationResult result = solve(instance);
    ASSERT_TRUE(result.reason.has_value());
    const auto edges = [&] {
      std::set<std::pair<std::pair<std::uint32_t, std::uint32_t>, Isometry>> found;
      for (const auto& cell : result.triangulation.cells)
        for (int i = 0; i <= instance.dimension; ++i)
          for (int j = 0; j <= instance.dimension; ++j) {
            const auto& a = cell[static_cast<std::size_t>(i)];
            const auto& b = cell[static_cast<std::size_t>(j)];
            if (i != j)
              found.insert({{a.point, b.point},
                            result.triangulation.elements[a.element].inverse() *
                                result.triangulation.elements[b.element]});
          }
      return found;
    }();
    EXPECT_TRUE(edges.count({{result.reason->first, result.reason->second}, result.reason->g}) == 1)
        << manifold;
    if (result.reason->kind == StayedInCover::Kind::two_cycle) {
      EXPECT_NE(result.reason->g, result.reason->h);
      EXPECT_TRUE(edges.count({{result.reason->first, result.reason->second}, result.reason->h}) == 1)
          << manifold;
    }
  }
}

TEST(Triangulate, TooManySheetsIsALimitThatSaysSo) {
  TriangulationOptions options;
  options.insertion = Insertion::covering;
  options.max_sheets = 10;
  try {
    static_cast<void>(solve(make("hexacosm", "uniform", 2, 1), options));
    FAIL() << "expected LimitReached";
  } catch (const LimitReached& limit) {
    EXPECT_NE(std::string(limit.what()).find("sheets"), std::string::npos) << limit.what();
  }
}

/// The counterexample of DESIGN ("Tempting and wrong"): T2, Gram diag(1,100), S = <(12,0),(0,3)>. With one
/// complete orbit of 0 and the copies q + S and q + (6,0) + S of q = (-5/2, 1/2) the quotient by S has a
/// 2-cycle: S is safe for complete orbits only, and the engine must work in a larger cover.
TEST(Covers, BoundingOneEndOfAnEdgeIsNotEnough) {
  const Instance instance = load("t2-long-two");
  const GroupAnalysis analysis = analyse(instance);
  const GroupTable table(analysis.frame);
  const std::vector<Site> sites = make_sites(analysis.frame, instance.points);
  ASSERT_EQ(sites.size(), 2U);
  const TieOrder order(analysis.frame, table);
  Predicates<2> predicates(analysis.frame, table, sites, order, PredicateStages::filtered);
  Circumradius<2> circumradius(analysis.frame, predicates);
  const Setting<2> setting{&analysis.frame, &table, &sites, &order, &predicates, &circumradius};
  const SiteId origin{0}, q{1};

  Sublattice small;
  small.basis = Matrix(2);
  small.basis(0, 0) = 12;
  small.basis(1, 1) = 3;
  small.index = small.sheets = 36;
  const auto two_copies_are_simplicial = [&](const Subgroup& subgroup, const Element& first,
                                             const Element& second) {
    PeriodicDelaunay<2> level(setting, subgroup);
    level.start(origin, triangulate_first_orbit<2>(analysis.frame, table, sites, order, predicates, origin));
    level.add_site(q);
    for (const Element& g : {first, second}) {
      const std::uint32_t rep = subgroup.split(g).rep;
      const Element copy = subgroup.representative(rep);
      level.insert(q, rep,
                   level.locate(q, copy, level.start_near(level.complex().lift(OrbitPoint{q, copy}))));
    }
    return !has_short_cycle<2>(table, subgroup, subgroup, level.complex().all_cells());
  };
  Element six;
  six.t[0] = 6;
  EXPECT_FALSE(two_copies_are_simplicial(Subgroup::sublattice(table, small), Element{}, six));
  const Sublattice safe = one_at_a_time_cover(analysis.frame, 20000);
  EXPECT_TRUE(two_copies_are_simplicial(Subgroup::sublattice(table, safe), Element{}, six));
}

/// L holds exactly the cells with 16 R^2 >= delta^2, at every step; the switch is monotone.
TEST(LargeCells, TheListIsExact) {
  const Instance instance = make("torus", "grid", 40, 3);
  const GroupAnalysis analysis = analyse(instance);
  const GroupTable table(analysis.frame);
  const std::vector<Site> sites = make_sites(analysis.frame, instance.points);
  const TieOrder order(analysis.frame, table);
  Predicates<2> predicates(analysis.frame, table, sites, order, PredicateStages::filtered);
  Circumradius<2> circumradius(analysis.frame, predicates);
  const Sublattice cover = one_at_a_time_cover(analysis.frame, 20000);
  DelaunayHierarchy<2> hierarchy({&analysis.frame, &table, &sites, &order, &predicates, &circumradius},
                                 Subgroup::sublattice(table, cover));
  bool on_manifold = false;
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    hierarchy.insert_orbit(SiteId{i}, 0);
    const PeriodicDelaunay<2>& level = hierarchy.full();
    std::size_t large = 0;
    for (const CellPoints<2>& cell : level.complex().all_cells()) {
      const auto [numerator, denominator] = predicates.exact().squared_circumradius(cell);
      if (Rational(Integer(16) * numerator, denominator) >= analysis.frame.delta_squared) ++large;
    }
    EXPECT_EQ(level.is_on_manifold(), large == 0) << i;
    if (!level.is_on_manifold()) {
      EXPECT_EQ(level.large_cells(), large) << i;
    }
    EXPECT_TRUE(!on_manifold || level.is_on_manifold()) << "Corollary 9: adding points keeps it";
    on_manifold = level.is_on_manifold();
  }
  EXPECT_TRUE(on_manifold);
}

/// Several levels, in covers and on the manifold, and a switch in the middle of the run.
TEST(Hierarchy, ManyPointsOfThePlanarManifolds) {
  for (const char* manifold : {"torus", "klein-bottle"}) {
    const Instance instance = make(manifold, "uniform", 2000, 4);
    TriangulationOptions options;
    options.insertion = Insertion::covering;
    const TriangulationResult result = solve(instance, options);
    EXPECT_GE(result.hierarchy_levels, 2U);
    EXPECT_EQ(result.sheets, 1);
    ASSERT_TRUE(result.switched_after.has_value());
    EXPECT_LT(*result.switched_after, 2000U);
    EXPECT_EQ(result.triangulation.cells.size(), 4000U);  // Euler number 0
  }
}

TEST(Subgroup, SplitsIntoSubgroupAndRepresentative) {
  for (const CatalogueEntry& entry : catalogue()) {
    const GroupAnalysis analysis = analyse(make(entry.name, "uniform", 1, 1));
    const GroupTable table(analysis.frame);
    const Subgroup h = Subgroup::sublattice(table, complete_orbit_cover(analysis.frame));
    EXPECT_EQ(static_cast<long>(h.index()), complete_orbit_cover(analysis.frame).sheets);
    for (std::uint32_t rep = 0; rep < h.index(); ++rep) {
      EXPECT_EQ(h.split(h.representative(rep)).rep, rep);
      EXPECT_TRUE(h.split(h.representative(rep)).s.is_identity());
    }
    for (std::int16_t x = -7; x < 8; ++x) {
      const Element g{{x, static_cast<std::int16_t>(3 - x), 0},
                      static_cast<std::uint16_t>(table.cosets() - 1)};
      const Subgroup::Split split = h.split(g);
      EXPECT_EQ(table.multiply(split.s, h.representative(split.rep)), g);
      EXPECT_EQ(h.split(split.s).rep, 0U);
    }
  }
}

}  // namespace
}  // namespace flatdt::ref
