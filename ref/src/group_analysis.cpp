#include "flatdt/ref/group_analysis.hpp"

#include "flatdt/ref/errors.hpp"
#include "group_parts.hpp"

namespace flatdt::ref {
namespace {

[[noreturn]] void fail_fixed_point(const WorkingGroup& working, const FixedPoint& found) {
  const Isometry to_instance = {working.basis, Vector(working.gram.dimension())};
  throw FixedPointError(to_instance * found.element * to_instance.inverse(), working.basis * found.point);
}

std::string names_of(const CatalogueEntry& entry) {
  std::string text = entry.name;
  for (std::size_t k = 0; k < entry.aliases.size(); ++k) text += (k == 0 ? " (" : ", ") + entry.aliases[k];
  return text + ")";
}

void check_name(const std::string& claimed, const CatalogueEntry& entry) {
  const CatalogueEntry* meant = find_entry(claimed);
  if (meant == nullptr)
    throw InvalidInput("no manifold is called \"" + shown(claimed) + "\"", InvalidInput::Section::manifold);
  if (meant != &entry)
    throw InvalidInput("the name \"" + claimed + "\" is wrong: the group is that of the " + names_of(entry),
                       InvalidInput::Section::manifold);
}

}  // namespace

FixedPointError::FixedPointError(const Isometry& element, const Vector& point)
    : InvalidInput("the group has an element of finite order: [" + shown(element.to_string()) + "] fixes (" +
                   shown(point.to_string()) + "), and only the identity may have a fixed point"),
      element_(element),
      point_(point) {}

GroupAnalysis analyse(const Instance& instance) {
  check_metric(instance.gram);
  const CosetGroup group = close_group(instance.generators, instance.gram);
  const WorkingGroup working = working_group(group, instance.gram);
  if (const auto found = find_fixed_point(working)) fail_fixed_point(working, *found);
  const CatalogueEntry& entry = recognise(working);
  if (instance.name) check_name(*instance.name, entry);

  const Rational lattice_volume = group.lattice.determinant();
  const auto order = static_cast<int>(group.cosets.size());
  return {.entry = &entry,
          .holonomy_order = order,
          .orientable = entry.orientable,
          .h1 = entry.h1,
          .lattice = group.lattice,
          .cosets = group.cosets,
          .volume_squared = lattice_volume * lattice_volume * instance.gram.determinant() /
                            Rational(Integer(order) * Integer(order)),
          .frame = make_frame(group, working, entry, instance.gram)};
}

}  // namespace flatdt::ref
