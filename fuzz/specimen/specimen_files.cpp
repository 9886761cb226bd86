/// Specimens as instances and triangulations in file coordinates, and back.
#include <algorithm>

#include "flatdt/ref/instance_format.hpp"
#include "specimen.hpp"

namespace flatdt::fuzz {
namespace {

ref::Matrix mean_over_linear_parts(const ref::Matrix& gram, const NamedGroup& group) {
  ref::Matrix sum(gram.dimension());
  for (const ref::Isometry& g : group.cosets) sum = sum + g.linear.transpose() * gram * g.linear;
  return ref::Rational(ref::Integer(1), ref::Integer(static_cast<long>(group.cosets.size()))) * sum;
}

std::vector<ref::Isometry> generators_of(const Specimen& specimen, const NamedGroup& group) {
  std::vector<ref::Isometry> generators = group.generators;
  const std::size_t n = generators.size();
  for (const std::uint8_t word : specimen.words) {
    const std::size_t i = word % n;
    const std::size_t j = word / n % n;
    generators[i] = i == j ? generators[i].inverse() : generators[i] * generators[j];
  }
  return generators;
}

const std::optional<ref::Isometry>& change_of(const Specimen& specimen) {
  static const std::optional<ref::Isometry> kNone;
  return specimen.named() == nullptr || specimen.name_only ? kNone : specimen.change;
}

/// to * g * from, from the inverse of to; g where nothing is changed.
ref::Isometry conjugate(const std::optional<ref::Isometry>& to, const ref::Isometry& g,
                        const std::optional<ref::Isometry>& from) {
  return to ? *to * g * *from : g;
}

std::optional<ref::Isometry> inverse_of(const std::optional<ref::Isometry>& change) {
  if (!change) return std::nullopt;
  return change->inverse();
}

/// The shift if g is the coset's representative after a translation by small integers.
std::optional<std::array<std::int8_t, 3>> shift_from(const ref::Isometry& g, const ref::Isometry& coset) {
  if (g.linear != coset.linear) return std::nullopt;
  const ref::Vector difference = g.translation - coset.translation;
  std::array<std::int8_t, 3> shift{};
  for (int i = 0; i < g.dimension(); ++i) {
    const ref::Rational& x = difference[i];
    if (!x.is_integer() || abs(x) > ref::Rational(127)) return std::nullopt;
    shift[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(x.numerator().to_long());
  }
  return shift;
}

CodedElement coded(const ref::Isometry& g, const Specimen& specimen) {
  CodedElement element;
  if (const NamedGroup* group = specimen.named()) {
    for (std::size_t c = 0; c < group->cosets.size(); ++c) {
      if (const auto shift = shift_from(g, group->cosets[c])) {
        element.coset = static_cast<std::uint8_t>(c);
        element.shift = *shift;
        return element;
      }
    }
  }
  element.listed = g;
  return element;
}

}  // namespace

int listed_group(int dimension) {
  return static_cast<int>(named_groups().size()) + (dimension == 2 ? 0 : 1);
}

const NamedGroup* Specimen::named() const {
  const auto index = static_cast<std::size_t>(group);
  return index < named_groups().size() ? &named_groups()[index] : nullptr;
}

int Specimen::dimension() const {
  const NamedGroup* known = named();
  if (known != nullptr) return known->entry->dimension;
  return group == listed_group(2) ? 2 : 3;
}

ref::Matrix metric_of(const Specimen& specimen) {
  const NamedGroup* group = specimen.named();
  if (group == nullptr) return specimen.gram ? *specimen.gram : ref::Matrix::identity(specimen.dimension());
  if (!specimen.gram) return group->entry->canonical_gram;
  const ref::Matrix mean = mean_over_linear_parts(*specimen.gram, *group);
  return is_positive_definite(mean) ? mean : group->entry->canonical_gram;
}

ref::Isometry element_of(const Specimen& specimen, const CodedElement& element) {
  if (element.listed) return *element.listed;
  ref::Isometry g = specimen.named()->cosets[element.coset];
  for (int i = 0; i < g.dimension(); ++i)
    g.translation[i] += ref::Rational(static_cast<int>(element.shift[static_cast<std::size_t>(i)]));
  return g;
}

ref::Instance instance_of(const Specimen& specimen) {
  ref::Instance instance;
  instance.dimension = specimen.dimension();
  instance.gram = metric_of(specimen);
  instance.points = specimen.points;
  const NamedGroup* group = specimen.named();
  if (group != nullptr && specimen.name_only) {
    instance.name = group->name;
    instance.generators = group->generators;
    return instance;
  }
  instance.generators_given = true;
  if (specimen.claim > 0) instance.name = named_groups()[static_cast<std::size_t>(specimen.claim) - 1].name;
  instance.generators = group != nullptr ? generators_of(specimen, *group) : specimen.generators;
  if (const std::optional<ref::Isometry>& change = change_of(specimen)) {
    const ref::Isometry inverse = change->inverse();
    for (ref::Isometry& g : instance.generators) g = *change * g * inverse;
    for (ref::Vector& x : instance.points) x = *change * x;
    instance.gram = inverse.linear.transpose() * instance.gram * inverse.linear;
  }
  return instance;
}

ref::Triangulation triangulation_of(const Specimen& specimen) {
  const std::optional<ref::Isometry>& change = change_of(specimen);
  const std::optional<ref::Isometry> back = inverse_of(change);
  ref::Triangulation result;
  result.dimension = specimen.dimension();
  result.has_subgroup = specimen.has_subgroup;
  for (const CodedElement& g : specimen.subgroup)
    result.subgroup.push_back(conjugate(change, element_of(specimen, g), back));
  for (const CodedElement& g : specimen.elements)
    result.elements.push_back(conjugate(change, element_of(specimen, g), back));
  for (const CodedCell& cell : specimen.cells) {
    std::array<ref::Triangulation::CellVertex, 4> vertices{};
    for (std::size_t i = 0; i <= static_cast<std::size_t>(result.dimension); ++i)
      vertices[i] = {cell[i].point, cell[i].element};
    result.cells.push_back(vertices);
  }
  return result;
}

std::optional<Specimen> specimen_of(const ref::Instance& instance) {
  if (instance.points.size() > kMaxPoints || instance.generators.size() > kMaxGenerators) return std::nullopt;
  Specimen specimen;
  specimen.points = instance.points;
  specimen.gram = instance.gram;
  const auto& groups = named_groups();
  if (instance.name) {
    // An alias becomes the name by which a specimen says the same.
    const ref::CatalogueEntry* entry = ref::find_entry(*instance.name);
    const auto& generators = ref::generators_of(*entry, *instance.name);
    const auto same = [&](const NamedGroup& g) { return g.entry == entry && g.generators == generators; };
    const auto index = static_cast<int>(std::find_if(groups.begin(), groups.end(), same) - groups.begin());
    specimen.claim = index + 1;
    specimen.group = index;
    specimen.name_only = !instance.generators_given;
  }
  if (instance.generators_given) {
    specimen.group = listed_group(instance.dimension);
    specimen.generators = instance.generators;
  }
  return specimen;
}

bool set_triangulation(Specimen& specimen, const ref::Triangulation& triangulation) {
  if (triangulation.elements.size() > kMaxElements || triangulation.cells.size() > kMaxCells ||
      triangulation.subgroup.size() > kMaxGenerators || triangulation.dimension != specimen.dimension())
    return false;
  const std::optional<ref::Isometry>& change = change_of(specimen);
  const std::optional<ref::Isometry> back = inverse_of(change);
  const auto code = [&](const ref::Isometry& g) { return coded(conjugate(back, g, change), specimen); };
  specimen.has_subgroup = triangulation.has_subgroup;
  specimen.subgroup.clear();
  specimen.elements.clear();
  specimen.cells.clear();
  for (const ref::Isometry& g : triangulation.subgroup) specimen.subgroup.push_back(code(g));
  for (const ref::Isometry& g : triangulation.elements) specimen.elements.push_back(code(g));
  for (const auto& cell : triangulation.cells) {
    CodedCell vertices{};
    for (std::size_t i = 0; i <= static_cast<std::size_t>(triangulation.dimension); ++i)
      vertices[i] = {static_cast<std::uint8_t>(cell[i].point), static_cast<std::uint8_t>(cell[i].element)};
    specimen.cells.push_back(vertices);
  }
  return true;
}

}  // namespace flatdt::fuzz
