// The rules that make a verdict of the statuses, and the conditions that must agree.
#include "flatdt/checker/verdict.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace flatdt::checker {
namespace {

using enum ConditionName;

Verdict all_hold() {
  Verdict v;
  for (Condition& c : v.conditions) c.status = Status::holds;
  return v;
}

Outcome concluded(Verdict v, bool claimed = true) {
  conclude(v, claimed);
  return v.outcome;
}

Outcome with(ConditionName name, Status status, bool claimed = true) {
  Verdict v = all_hold();
  v[name].status = status;
  return concluded(v, claimed);
}

TEST(Verdict, NamesAreThoseOfTheFormat) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kConditionCount; ++i) names.insert(to_string(static_cast<ConditionName>(i)));
  EXPECT_EQ(names.size(), kConditionCount);
  EXPECT_EQ(to_string(group_crystallographic), "group.crystallographic");
  EXPECT_EQ(to_string(delaunay_empty), "delaunay.empty");
  EXPECT_EQ(to_string(topology_homology), "topology.homology");
}

TEST(Verdict, AllHold) {
  EXPECT_EQ(concluded(all_hold()), Outcome::verified);
}

TEST(Verdict, SkippingIsAllowedForNameAndHomologyOnly) {
  for (std::size_t i = 0; i < kConditionCount; ++i) {
    const auto name = static_cast<ConditionName>(i);
    const bool expected = name == topology_homology || name == group_name;
    EXPECT_EQ(with(name, Status::skipped, false) == Outcome::verified, expected) << to_string(name);
  }
  EXPECT_EQ(with(group_name, Status::skipped, true), Outcome::unknown);
}

TEST(Verdict, OneFailure) {
  for (const ConditionName name : {group_crystallographic, group_torsion_free, group_name}) {
    EXPECT_EQ(with(name, Status::fails), Outcome::malformed);
  }
  for (const ConditionName name : {subgroup_member, vertices_complete, cells_nondegenerate, facets_paired,
                                   facets_opposite, volume_exact, delaunay_empty}) {
    EXPECT_EQ(with(name, Status::fails), Outcome::refuted) << to_string(name);
  }
}

// In a tiling these cannot fail alone: the checker contradicts itself, and says so even if something else
// failed too.
TEST(Verdict, DisagreementIsUnknown) {
  for (const ConditionName name :
       {simplices_injective, skeleton_no_loop, skeleton_no_2_cycle, complex_intersection, links_spheres,
        topology_connected, topology_euler, topology_orientable, topology_homology}) {
    EXPECT_EQ(with(name, Status::fails), Outcome::unknown) << to_string(name);
    Verdict v = all_hold();
    v[name].status = Status::fails;
    v[delaunay_empty].status = Status::fails;
    conclude(v, true);
    EXPECT_EQ(v.outcome, Outcome::unknown) << to_string(name);
    EXPECT_NE(v.reason.find("contradicts itself"), std::string::npos);
  }
}

TEST(Verdict, AgreeingFailuresAreRefuted) {
  Verdict loop = all_hold();
  for (const ConditionName name : {simplices_injective, skeleton_no_loop, complex_intersection}) {
    loop[name].status = Status::fails;
  }
  EXPECT_EQ(concluded(loop), Outcome::refuted);
  Verdict cycle = all_hold();
  for (const ConditionName name : {skeleton_no_2_cycle, complex_intersection})
    cycle[name].status = Status::fails;
  EXPECT_EQ(concluded(cycle), Outcome::refuted);
}

TEST(Verdict, OutsideATilingNothingMustAgree) {
  for (const ConditionName broken : {cells_nondegenerate, facets_paired, facets_opposite, volume_exact}) {
    Verdict v = all_hold();
    v[broken].status = Status::fails;
    v[links_spheres].status = Status::fails;
    v[topology_euler].status = Status::fails;
    EXPECT_EQ(concluded(v), Outcome::refuted);
  }
}

}  // namespace
}  // namespace flatdt::checker
