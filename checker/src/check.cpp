#include "flatdt/checker/check.hpp"

#include <algorithm>
#include <new>
#include <utility>
#include <variant>

#include "catalogue.hpp"
#include "context.hpp"
#include "flatdt/checker/errors.hpp"
#include "linear.hpp"

namespace flatdt::checker {
namespace {

using enum ConditionName;

void fail_group(Verdict& verdict, const Instance& instance, ConditionName name, Witness witness) {
  verdict.reason = instance.group_location + ": " + std::string(to_string(name)) + " fails:";
  for (const auto& [key, value] : witness) verdict.reason.append(" ").append(key).append("=").append(value);
  verdict[name] = {Status::fails, std::move(witness)};
}

/// group.crystallographic, group.torsion-free, group.name; the group if they hold (the last also if skipped).
std::optional<Group> check_group(const Instance& instance, Verdict& verdict) {
  const int d = instance.dimension;
  std::variant<Crystal, Witness> closed = close_group(d, instance.generators, &instance.metric);
  if (Witness* witness = std::get_if<Witness>(&closed)) {
    fail_group(verdict, instance, group_crystallographic, std::move(*witness));
    return std::nullopt;
  }
  const Crystal& crystal = std::get<Crystal>(closed);
  if (const int rank = crystal.lattice.rank(); rank < d) {
    fail_group(verdict, instance, group_crystallographic,
               {{"reason", "not-cocompact"}, {"rank-of-lattice", std::to_string(rank)}});
    return std::nullopt;
  }
  Group group = make_group(crystal);
  verdict[group_crystallographic] = {Status::holds, {{"linear-parts", number_text(group.order())}}};
  if (const std::optional<TorsionElement> torsion = find_torsion(group)) {
    fail_group(verdict, instance, group_torsion_free,
               {{"element", to_string(d, torsion->element)},
                {"fixed-point", to_string(d, torsion->fixed_point)},
                {"order", number_text(torsion->order)}});
    return std::nullopt;
  }
  verdict[group_torsion_free] = {Status::holds, {}};
  if (!instance.claim) return group;
  const std::string holonomy = holonomy_name(group);
  const std::string homology = to_string(first_homology(group));
  const std::string name(
      recognise(d, is_orientable(group), holonomy, homology).value_or("none-of-the-catalogue"));
  Witness witness = {{"claimed", *instance.claim},
                     {"manifold", name},
                     {"orientable", is_orientable(group) ? "yes" : "no"},
                     {"holonomy", holonomy},
                     {"H1", homology}};
  if (name != *instance.claim) {
    fail_group(verdict, instance, group_name, std::move(witness));
    return std::nullopt;
  }
  verdict[group_name] = {Status::holds, std::move(witness)};
  return group;
}

/// subgroup.member; the subgroup and the ids of the listed elements if it holds.
std::optional<Subgroup> check_subgroup(const Triangulation& triangulation, ElementTable& table,
                                       std::vector<ElementId>& elements, Verdict& verdict) {
  const Group& group = table.group();
  const std::vector<Seitz>* generators = triangulation.subgroup ? &*triangulation.subgroup : nullptr;
  std::variant<Subgroup, Witness> made = Subgroup::make(group, generators);
  if (Witness* witness = std::get_if<Witness>(&made)) {
    verdict[subgroup_member] = {Status::fails, std::move(*witness)};
    return std::nullopt;
  }
  for (std::size_t k = 0; k < triangulation.elements.size(); ++k) {
    const Seitz listed = triangulation.element(k);
    const std::optional<Element> element = group.locate(listed);
    if (!element) {
      verdict[subgroup_member] = {Status::fails,
                                  {{"reason", "element-not-in-group"},
                                   {"number", number_text(k)},
                                   {"element", to_string(group.dimension, listed)}}};
      return std::nullopt;
    }
    elements.push_back(table.intern(*element));
  }
  Subgroup subgroup = std::get<Subgroup>(std::move(made));
  verdict[subgroup_member] = {Status::holds, {{"index", subgroup.index().get_str()}}};
  return subgroup;
}

void check_all(const Instance& instance, const Triangulation& triangulation, const Stages& stages,
               Verdict& verdict) {
  const std::optional<Group> group = check_group(instance, verdict);
  if (!group) return;
  ElementTable table(*group);
  std::vector<ElementId> elements;
  const std::optional<Subgroup> subgroup = check_subgroup(triangulation, table, elements, verdict);
  if (!subgroup) return;
  const Orbits orbits = make_orbits(instance, table, stages.fixed_width);
  const Complex complex = make_complex(triangulation, elements, orbits, *subgroup, table);
  Geometry geometry(complex, orbits, table, instance.metric, stages);
  const unsigned jobs = std::clamp(stages.jobs, 1U, Stages::kMostJobs);
  const Faces faces = find_faces(complex, jobs);
  Context context{instance, triangulation, *group,  *subgroup, orbits, complex,
                  table,    geometry,      verdict, faces,     jobs};
  check_vertices(context);
  check_cells(context);
  check_facets(context);
  check_delaunay(context);
  check_simplices(context);
  check_skeleton(context);
  check_intersection(context);
  check_links(context);
  check_topology(context);
  check_homology(context);
}

}  // namespace

Verdict check(const Instance& instance, const Triangulation& triangulation, const Stages& stages) {
  Verdict verdict;
  try {
    check_all(instance, triangulation, stages, verdict);
    conclude(verdict, instance.claim.has_value());
    return verdict;
  } catch (const ResourceLimit& limit) {
    verdict.reason = std::string("limit of the checker: ") + limit.what();
  } catch (const InternalError& error) {
    verdict.reason = std::string("the checker contradicts itself: ") + error.what();
  } catch (const std::bad_alloc&) {
    verdict.reason = "out of memory";
  }
  verdict.outcome = Outcome::unknown;
  return verdict;
}

}  // namespace flatdt::checker
