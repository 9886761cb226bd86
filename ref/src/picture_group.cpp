#include "picture_group.hpp"

#include <algorithm>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::picture {

ShownGroup shown_group(const Instance& instance, const Triangulation& triangulation, const PictureGroup& full,
                       std::vector<std::string>& notes) {
  if (!triangulation.has_subgroup) return {full};
  Instance cover = instance;
  cover.name.reset();
  cover.generators = triangulation.subgroup;
  cover.generators_given = true;
  try {
    return {PictureGroup(analyse(cover))};
  } catch (const InvalidInput& error) {
    notes.push_back("The subgroup is not admissible, so only the listed cells are drawn: " +
                    std::string(error.what()) + ".");
    return {full, false};
  }
}

std::string title_of(const Triangulation& triangulation, const PictureGroup& full) {
  std::string name = full.name == "klein-bottle" ? "Klein bottle" : full.name;
  std::replace(name.begin(), name.end(), '-', ' ');
  return (triangulation.has_subgroup ? "Triangulation of a covering space of the "
                                     : "Triangulation of the ") +
         name;
}

Simplex simplex_of(const Instance& instance, const Triangulation& triangulation, std::size_t cell) {
  Simplex corners;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(instance.dimension); ++k) {
    const auto& vertex = triangulation.cells[cell][k];
    corners.push_back(triangulation.elements[vertex.element] * instance.points[vertex.point]);
  }
  return corners;
}

Vector barycentre(const Simplex& simplex) {
  Vector sum = simplex[0];
  for (std::size_t k = 1; k < simplex.size(); ++k) sum = sum + simplex[k];
  return Rational(Integer(1), Integer(static_cast<long>(simplex.size()))) * sum;
}

Vector shift_into_cell(const PictureGroup& group, const Vector& x) {
  Vector u = group.inverse * x;
  for (int i = 0; i < u.dimension(); ++i) u[i] = -Rational(floor(u[i]));
  return group.basis * u;
}

Isometry to_least(const PictureGroup& group, const Vector& x) {
  const int d = group.dimension();
  Isometry best = Isometry::identity(d);
  Vector least(d);
  bool found = false;
  for (const Isometry& g : group.cosets) {
    const Vector image = g * x, shift = shift_into_cell(group, image);
    if (found && !(image + shift < least)) continue;
    found = true;
    least = image + shift;
    best = Isometry::translate(shift) * g;
  }
  return best;
}

}  // namespace flatdt::ref::picture
