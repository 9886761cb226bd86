/// Theorem 7 and its converse: E^d/G carries the triangulation iff its 1-skeleton modulo G has no loop and no
/// 2-cycle. The skeleton is computed here from the written cells, independently of the reference; the
/// checker's conditions must say the same of the cells claimed for the manifold.
#include <gtest/gtest.h>

#include "for_all.hpp"
#include "judge.hpp"
#include "quotient.hpp"
#include "require.hpp"
#include "subgroups.hpp"

namespace flatdt::property_tests {
namespace {

using checker::ConditionName;
using ref::StayedInCover;

/// The cells modulo G as a claim about the manifold: one of each class, no subgroup.
ref::Triangulation claimed_for_the_manifold(const Specimen& s, const ref::Instance& instance,
                                            const ref::Triangulation& written) {
  const Quotient quotient(s);
  std::set<Vector> seen;
  ref::Triangulation claim;
  claim.dimension = written.dimension;
  claim.elements = written.elements;
  const auto corners = corners_of(instance, written, s.coordinates);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const Folded one = fold(quotient, {corners[c]});
    if (seen.insert(one.cells.begin()->first).second) claim.cells.push_back(written.cells[c]);
  }
  return claim;
}

/// Every condition has the expected status on a weakly Delaunay tiling of the manifold whose skeleton has
/// these cycles.
void require_statuses(const checker::Verdict& verdict, bool loop, bool two_cycle) {
  for (std::size_t i = 0; i < checker::kConditionCount; ++i) {
    const auto name = static_cast<ConditionName>(i);
    bool fails = false;
    switch (name) {
      case ConditionName::simplices_injective:
      case ConditionName::skeleton_no_loop:
        fails = loop;
        break;
      case ConditionName::skeleton_no_2_cycle:
        fails = two_cycle;
        break;
      case ConditionName::complex_intersection:
        fails = loop || two_cycle;
        break;
      case ConditionName::group_name:
        if (verdict[name].status == checker::Status::skipped) continue;  // no name was claimed
        break;
      default:
        break;
    }
    require(verdict[name].status == (fails ? checker::Status::fails : checker::Status::holds),
            "the skeleton has " + std::string(loop ? "a loop, " : "no loop, ") +
                (two_cycle ? "a 2-cycle" : "no 2-cycle") + "; the checker says " + summary(verdict));
  }
}

/// The cycle that the reference names is one of the skeleton's.
void require_witness(const Specimen& s, const ref::Instance& instance, const StayedInCover& reason,
                     const Quotient& quotient, const Skeleton& edges) {
  const auto is_edge = [&](const Isometry& g) {
    const Quotient::Canonical tail = quotient.canonical(s.coordinates * instance.points[reason.first]);
    const Vector head = tail.mover * (s.coordinates * (g * instance.points[reason.second]));
    const auto heads = edges.find(tail.point);
    return heads != edges.end() && heads->second.count(head) == 1;
  };
  require(is_edge(reason.g), "the first edge of the named cycle is no edge");
  if (reason.kind == StayedInCover::Kind::loop) {
    require(reason.first == reason.second && !reason.g.is_identity(), "the named loop is no loop");
  } else {
    require(is_edge(reason.h) && reason.g != reason.h, "the second edge of the named 2-cycle is no edge");
  }
}

struct LoopVisits {
  int on_manifold = 0, loops = 0, two_cycles_only = 0, not_invariant = 0;
};

void both_ways(const Specimen& s, LoopVisits& visits) {
  const ref::Instance instance = instance_of(s);
  const ref::TriangulationResult result = triangulate(instance);
  const Quotient quotient(s);
  const Folded folded = fold(quotient, corners_of(instance, result.triangulation, s.coordinates));
  const bool invariant = folded.evenly && folded.multiplicity == static_cast<std::size_t>(result.sheets);
  if (!invariant) {
    require(result.reason && result.reason->kind == StayedInCover::Kind::not_invariant,
            "the triangulation is not invariant under the group, and the reference does not say so");
    require(s.entry->name == "didicosm", "only the didicosm's tie order is not invariant");
    ++visits.not_invariant;
    return;
  }
  const Skeleton edges = skeleton(quotient, folded);
  const bool loop = has_loop(quotient, edges);
  const bool two_cycle = has_two_cycle(quotient, edges);
  require(result.reason.has_value() == (loop || two_cycle),
          "Theorem 7: the manifold is answered iff there is no loop and no 2-cycle");
  require(result.triangulation.has_subgroup == result.reason.has_value(),
          "a cover is written iff there is a reason");
  if (result.reason) {
    require((result.reason->kind == StayedInCover::Kind::loop) == loop, "the wrong kind of cycle is named");
    require_witness(s, instance, *result.reason, quotient, edges);
  }
  const checker::Verdict verdict =
      judge(instance, claimed_for_the_manifold(s, instance, result.triangulation));
  require_statuses(verdict, loop, two_cycle);
  ++(loop ? visits.loops : two_cycle ? visits.two_cycles_only : visits.on_manifold);
}

/// Without ties: a cover that always carries a triangulation (translations by 3L) decides about the manifold.
void decided_in_a_cover(const Specimen& s, int& decided) {
  const ref::Instance instance = instance_of(s);
  const ref::TriangulationResult on_manifold = triangulate(instance);
  std::vector<Isometry> multiples;
  for (int j = 0; j < s.dimension(); ++j) {
    Vector t(s.dimension());
    t[j] = 3;
    multiples.push_back(Isometry::translate(t));
  }
  const SubgroupInstance cover = subgroup_instance(s, multiples);
  const ref::TriangulationResult in_cover = triangulate(cover.instance);
  require(!in_cover.reason, "3L always carries the triangulation");
  const Quotient quotient(s);
  const Folded folded = fold(quotient, corners_of(cover.instance, in_cover.triangulation, s.coordinates));
  if (has_ties(tessellate(quotient, s.gram, folded), s.dimension())) return;
  require(folded.evenly && folded.multiplicity == cover.index, "without ties the cells are invariant");
  const Skeleton edges = skeleton(quotient, folded);
  require(on_manifold.reason.has_value() == (has_loop(quotient, edges) || has_two_cycle(quotient, edges)),
          "Theorem 7, from the triangulation of a cover");
  ++decided;
}

/// A triangulation of the manifold is one of each of its covers.
void lifts_to_covers(const Specimen& s, int& lifts) {
  const ref::Instance instance = instance_of(s);
  ref::Triangulation t = triangulate(instance).triangulation;
  if (t.has_subgroup) return;
  const SubgroupInstance cover = draw_subgroup(s, 8, s.choice);
  // The points of the subgroup's instance are r p, r over the cosets, p over the points.
  const std::size_t n = instance.points.size();
  ref::Triangulation lifted;
  lifted.dimension = t.dimension;
  lifted.has_subgroup = true;
  lifted.subgroup = cover.instance.generators;
  for (std::size_t r = 0; r < cover.index; ++r) {
    const Isometry& mover = cover.representatives[r];
    for (const auto& cell : t.cells) {
      lifted.cells.push_back(cell);
      for (std::size_t k = 0; k <= static_cast<std::size_t>(t.dimension); ++k)
        lifted.cells.back()[k].element += static_cast<std::uint32_t>(r * t.elements.size());
    }
    for (const Isometry& g : t.elements) lifted.elements.push_back(mover * g);
  }
  require(cover.instance.points.size() == cover.index * n, "a point for each coset");
  require_verified(instance, lifted);
  ++lifts;
}

TEST(Theorem7, BothWaysInThePlane) {
  Domain domain = plane();
  domain.max_points_in_plane = 45;
  domain.max_stretch_in_plane = 4;
  LoopVisits visits;
  if (for_all({150, domain}, [&](const Specimen& s) { both_ways(s, visits); }) == 0) return;
  EXPECT_GT(visits.on_manifold, 10);
  EXPECT_GT(visits.loops, 10);
  EXPECT_GT(visits.two_cycles_only, 10);
}
TEST(Theorem7, BothWaysInSpace) {
  LoopVisits visits;
  for_all({12, space()}, [&](const Specimen& s) { both_ways(s, visits); });
}
TEST(Theorem7, BothWaysWithTiesOfTheDidicosm) {
  Domain domain = domain_of({"didicosm"});
  domain.max_points_in_space = 2;
  domain.other_metrics = false;
  domain.rules = {testing::kSmallGridRule, "on-axis"};
  LoopVisits visits;
  if (for_all({15, domain}, [&](const Specimen& s) { both_ways(s, visits); }) == 0) return;
  EXPECT_GT(visits.not_invariant, 0);
  EXPECT_GT(visits.loops + visits.two_cycles_only, 0);
}
TEST(Theorem7, DecidedInACover) {
  Domain domain = plane();
  domain.max_points_in_plane = 8;
  domain.max_stretch_in_plane = 3;
  int decided = 0;
  if (for_all({40, domain}, [&](const Specimen& s) { decided_in_a_cover(s, decided); }) == 0) return;
  EXPECT_GT(decided, 10);
}
TEST(Theorem7, LiftsToCovers) {
  Domain domain = plane();
  domain.max_points_in_plane = 70;
  domain.max_stretch_in_plane = 2;
  int lifts = 0;
  if (for_all({60, domain}, [&](const Specimen& s) { lifts_to_covers(s, lifts); }) == 0) return;
  EXPECT_GT(lifts, 10);
}

}  // namespace
}  // namespace flatdt::property_tests
