#include "flatdt/testing/specimen.hpp"

#include <algorithm>
#include <ostream>
#include <stdexcept>

#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::testing {

using ref::Isometry;
using ref::Matrix;
using ref::Vector;

std::string name_of(const Specimen& specimen) {
  return specimen.mirrored ? specimen.entry->mirror_aliases.front() : specimen.entry->name;
}

const std::vector<Isometry>& catalogue_generators(const Specimen& specimen) {
  return ref::generators_of(*specimen.entry, name_of(specimen));
}

bool means_mirror_image(const ref::CatalogueEntry& entry, const std::string& name) {
  return std::find(entry.mirror_aliases.begin(), entry.mirror_aliases.end(), name) !=
         entry.mirror_aliases.end();
}

Specimen empty_specimen(const std::string& manifold) {
  Specimen specimen;
  specimen.entry = ref::find_entry(manifold);
  if (specimen.entry == nullptr) throw std::invalid_argument("no manifold is called " + manifold);
  specimen.mirrored = means_mirror_image(*specimen.entry, manifold);
  specimen.gram = specimen.entry->canonical_gram;
  specimen.generators = catalogue_generators(specimen);
  specimen.coordinates = Isometry::identity(specimen.dimension());
  return specimen;
}

ref::Instance instance_of(const Specimen& specimen) {
  const bool plain =
      specimen.coordinates.is_identity() && specimen.generators == catalogue_generators(specimen);
  ref::Instance instance;
  instance.dimension = specimen.dimension();
  instance.generators_given = specimen.naming != Naming::name_only || !plain;
  if (specimen.naming != Naming::generators_only) {
    const bool in_force =
        !specimen.alias.empty() && (instance.generators_given ||
                                    means_mirror_image(*specimen.entry, specimen.alias) == specimen.mirrored);
    instance.name = in_force ? specimen.alias : name_of(specimen);
  }
  const Isometry back = specimen.coordinates.inverse();
  for (const Isometry& g : specimen.generators)
    instance.generators.push_back(back * g * specimen.coordinates);
  const Matrix& b = specimen.coordinates.linear;
  instance.gram = b.transpose() * specimen.gram * b;
  for (const Vector& x : specimen.points) instance.points.push_back(back * x);
  return instance;
}

Specimen specimen_of(const ref::Instance& instance) {
  const ref::GroupAnalysis analysis = ref::analyse(instance);
  const ref::Frame& frame = analysis.frame;
  Specimen specimen;
  specimen.entry = frame.entry;
  specimen.mirrored = frame.mirrored;
  specimen.family = "given";
  specimen.alias = instance.name.value_or("");
  const Isometry to_instance = Isometry{frame.basis, frame.origin} *
                               Isometry{frame.to_catalogue.inverse(), Vector(instance.dimension)};
  specimen.coordinates = to_instance.inverse();
  const Matrix& back = to_instance.linear;
  specimen.gram = back.transpose() * instance.gram * back;
  for (const Isometry& g : instance.generators)
    specimen.generators.push_back(specimen.coordinates * g * to_instance);
  for (const Vector& x : instance.points) specimen.points.push_back(specimen.coordinates * x);
  specimen.naming = !instance.generators_given ? Naming::name_only
                    : instance.name            ? Naming::name_and_generators
                                               : Naming::generators_only;
  return specimen;
}

std::ostream& operator<<(std::ostream& out, const Specimen& specimen) {
  return out << "# family " << specimen.family << ", choice " << specimen.choice << "\n"
             << ref::write_instance(instance_of(specimen));
}

Specimen read_specimen(const std::string& text, const std::string& file_name) {
  Specimen specimen = specimen_of(ref::parse_instance(text, file_name));
  const std::string key = ", choice ";
  const std::size_t line = ("\n" + text).find("\n# family ");
  if (line == std::string::npos) return specimen;
  const std::string comment = text.substr(line, text.find('\n', line) - line);
  if (const std::size_t at = comment.find(key); at != std::string::npos)
    specimen.choice = std::stoull(comment.substr(at + key.size()));
  return specimen;
}

}  // namespace flatdt::testing
