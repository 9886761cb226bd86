/// What pictures need of a group acting on E^d: coset representatives and the reduced basis of its lattice.
#pragma once

#include <string>
#include <vector>

#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::ref::picture {

struct PictureGroup {
  explicit PictureGroup(const GroupAnalysis& analysis)
      : name(analysis.entry->name),
        cosets(analysis.cosets),
        basis(analysis.frame.basis),
        inverse(basis.inverse()),
        gram(analysis.frame.gram) {}

  [[nodiscard]] int dimension() const { return basis.dimension(); }

  std::string name;
  std::vector<Isometry> cosets;
  Matrix basis, inverse, gram;  // columns in instance coordinates; gram of the columns
};

/// The group whose copies are drawn: that of the cover, or of the manifold.
struct ShownGroup {
  PictureGroup group;
  /// False if the subgroup of the file is not admissible: then group is that of the manifold, for placement
  /// alone, and nothing may be copied.
  bool has_copies = true;
};
/// Adds a note if the subgroup is not admissible.
ShownGroup shown_group(const Instance& instance, const Triangulation& triangulation, const PictureGroup& full,
                       std::vector<std::string>& notes);

/// For example "Triangulation of the Klein bottle".
std::string title_of(const Triangulation& triangulation, const PictureGroup& full);

using Simplex = std::vector<Vector>;
/// The vertices of a listed cell.
Simplex simplex_of(const Instance& instance, const Triangulation& triangulation, std::size_t cell);
Vector barycentre(const Simplex& simplex);

/// The lattice vector that brings x into the fundamental cell spanned by the basis.
Vector shift_into_cell(const PictureGroup& group, const Vector& x);
/// The element g of the group for which g x is the least point of the orbit in the fundamental cell.
Isometry to_least(const PictureGroup& group, const Vector& x);

}  // namespace flatdt::ref::picture
