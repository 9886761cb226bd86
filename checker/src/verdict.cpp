#include "flatdt/checker/verdict.hpp"

#include <algorithm>

namespace flatdt::checker {
namespace {

constexpr std::array<std::string_view, kConditionCount> kNames = {
    "group.crystallographic", "group.torsion-free",   "group.name",          "subgroup.member",
    "vertices.complete",      "cells.nondegenerate",  "facets.paired",       "facets.opposite",
    "volume.exact",           "delaunay.empty",       "simplices.injective", "skeleton.no-loop",
    "skeleton.no-2-cycle",    "complex.intersection", "links.spheres",       "topology.connected",
    "topology.euler",         "topology.orientable",  "topology.homology"};

/// The first disagreement among conditions that must agree, or empty.   Source: docs/soundness.md, section 6.
std::string disagreement(const Verdict& v) {
  using enum ConditionName;
  const auto holds = [&](ConditionName name) { return v[name].status == Status::holds; };
  const bool tiling =
      holds(cells_nondegenerate) && holds(facets_paired) && holds(facets_opposite) && holds(volume_exact);
  if (!tiling) return "";
  if (holds(simplices_injective) != holds(skeleton_no_loop)) {
    return "simplices.injective and skeleton.no-loop must agree in a tiling";
  }
  if (holds(complex_intersection) != (holds(skeleton_no_loop) && holds(skeleton_no_2_cycle))) {
    return "complex.intersection must hold in a tiling exactly if skeleton.no-loop and skeleton.no-2-cycle "
           "do";
  }
  for (const ConditionName name :
       {links_spheres, topology_connected, topology_euler, topology_orientable, topology_homology}) {
    if (v[name].status == Status::fails) return std::string(to_string(name)) + " must hold in a tiling";
  }
  return "";
}

}  // namespace

std::string_view to_string(ConditionName name) {
  return kNames[static_cast<std::size_t>(name)];
}

std::string_view to_string(Status status) {
  constexpr std::array<std::string_view, 3> kWords = {"holds", "fails", "skipped"};
  return kWords[static_cast<std::size_t>(status)];
}

std::string_view to_string(Outcome outcome) {
  constexpr std::array<std::string_view, 4> kWords = {"VERIFIED", "REFUTED", "MALFORMED", "UNKNOWN"};
  return kWords[static_cast<std::size_t>(outcome)];
}

void conclude(Verdict& verdict, bool claimed) {
  using enum ConditionName;
  const auto fails = [](const Condition& c) { return c.status == Status::fails; };
  for (const ConditionName name : {group_crystallographic, group_torsion_free, group_name}) {
    if (!fails(verdict[name])) continue;
    verdict.outcome = Outcome::malformed;
    return;
  }
  if (std::string clash = disagreement(verdict); !clash.empty()) {
    verdict.outcome = Outcome::unknown;
    verdict.reason = "the checker contradicts itself: " + clash;
    return;
  }
  if (std::any_of(verdict.conditions.begin(), verdict.conditions.end(), fails)) {
    verdict.outcome = Outcome::refuted;
    return;
  }
  for (std::size_t i = 0; i < kConditionCount; ++i) {
    const auto name = static_cast<ConditionName>(i);
    const bool may_skip = (name == group_name && !claimed) || name == topology_homology;
    if (verdict[name].status == Status::holds || may_skip) continue;
    verdict.outcome = Outcome::unknown;
    verdict.reason = std::string(to_string(name)) + " was skipped though nothing failed";
    return;
  }
  verdict.outcome = Outcome::verified;
}

}  // namespace flatdt::checker
