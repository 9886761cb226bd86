#include "flatdt/ref/triangulate.hpp"

#include <utility>

#include "instance_elements.hpp"

namespace flatdt::ref {
namespace {

StayedInCover explain(const ShortCycle& cycle, const InstanceElements& elements) {
  StayedInCover reason;
  reason.kind = cycle.loop ? StayedInCover::Kind::loop : StayedInCover::Kind::two_cycle;
  reason.first = elements.site(cycle.first).point;
  reason.second = elements.site(cycle.second).point;
  reason.g = elements.between(cycle.first, {cycle.second, cycle.g});
  reason.h = elements.between(cycle.first, {cycle.second, cycle.h});
  return reason;
}

template <int D>
StayedInCover explain(const typename FrameTriangulation<D>::Variance& variance,
                      const InstanceElements& elements) {
  StayedInCover reason;
  reason.kind = StayedInCover::Kind::not_invariant;
  reason.g = elements.conjugate(elements.group().table().isometry(variance.element));
  for (const OrbitPoint& p : variance.cell) {
    if (!reason.cell.empty()) reason.cell += ", ";
    reason.cell +=
        "(" + elements.at(p).to_string() + ") * points[" + std::to_string(elements.site(p.site).point) + "]";
  }
  return reason;
}

template <int D>
TriangulationResult in_instance(FrameTriangulation<D> answer, const PreparedGroup& group) {
  const InstanceElements elements(group, answer.sites);
  TriangulationResult result;
  result.distinct_points = answer.sites.size();
  result.working_cover = answer.working_cover;
  result.switched_after = answer.switched_after;
  result.hierarchy_levels = answer.hierarchy_levels;
  result.delta_squared = group.frame().delta_squared;
  result.empty_diameter_squared = empty_diameter_squared<D>(answer, group);
  if (answer.cover)
    result.triangulation = to_triangulation<D>(
        CellList<D>(unfold<D>(group.table(), group.order().invariance_group(),
                              Subgroup::sublattice(group.table(), *answer.cover), answer.cells.listed())),
        elements);
  else
    result.triangulation = to_triangulation<D>(std::move(answer.cells), elements);
  if (answer.cycle) result.reason = explain(*answer.cycle, elements);
  if (answer.variance) result.reason = explain<D>(*answer.variance, elements);
  if (answer.cover) {
    result.sheets = answer.cover->sheets;
    result.triangulation.has_subgroup = true;
    for (int j = 0; j < D; ++j)
      result.triangulation.subgroup.push_back(
          elements.conjugate(Isometry::translate(answer.cover->basis.column(j))));
  }
  return result;
}

}  // namespace

TriangulationResult triangulate(const Instance& instance, const PreparedGroup& group,
                                const TriangulationOptions& options) {
  if (instance.dimension == 2)
    return in_instance<2>(triangulate_in_frame<2>(instance.points, group, options), group);
  return in_instance<3>(triangulate_in_frame<3>(instance.points, group, options), group);
}

TriangulationResult triangulate(Instance&& instance, const PreparedGroup& group,
                                const TriangulationOptions& options) {
  if (instance.dimension == 2)
    return in_instance<2>(triangulate_in_frame<2>(std::move(instance.points), group, options), group);
  return in_instance<3>(triangulate_in_frame<3>(std::move(instance.points), group, options), group);
}

TriangulationResult triangulate(const Instance& instance, const GroupAnalysis& analysis,
                                const TriangulationOptions& options) {
  return triangulate(instance, PreparedGroup(analysis), options);
}

std::vector<std::string> describe(const TriangulationResult& result) {
  std::vector<std::string> lines;
  if (!result.reason) {
    lines.emplace_back("Delaunay triangulation of the manifold");
    return lines;
  }
  const StayedInCover& reason = *result.reason;
  lines.push_back("Delaunay triangulation of a covering space with " + std::to_string(result.sheets) +
                  " sheets: for this tie-break the manifold itself carries none, because");
  switch (reason.kind) {
    case StayedInCover::Kind::loop:
      lines.push_back("loop: the edge from points[" + std::to_string(reason.first) + "] to (" +
                      reason.g.to_string() + ") * points[" + std::to_string(reason.second) + "]");
      break;
    case StayedInCover::Kind::two_cycle:
      lines.push_back("2-cycle: the edges from points[" + std::to_string(reason.first) + "] to (" +
                      reason.g.to_string() + ") * points[" + std::to_string(reason.second) + "] and to (" +
                      reason.h.to_string() + ") * points[" + std::to_string(reason.second) + "]");
      break;
    case StayedInCover::Kind::not_invariant:
      lines.push_back("not invariant: the cell " + reason.cell + " is not mapped to a cell by (" +
                      reason.g.to_string() + ")");
      break;
  }
  return lines;
}

}  // namespace flatdt::ref
