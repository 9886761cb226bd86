/// A specimen: an instance together with how it was made, so that it can be varied, simplified and printed.
/// Invariants: metric, generators and points stand in catalogue coordinates, where the translation lattice is
/// Z^d; the instance stands in coordinates of its own, x_catalogue = coordinates * x_instance.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/instance.hpp"

namespace flatdt::testing {

/// What the instance file says about the group.
enum class Naming : std::uint8_t {
  name_only,            // the catalogue's generators are meant
  name_and_generators,  // a claim that is verified
  generators_only,
};

struct Specimen {
  const ref::CatalogueEntry* entry = nullptr;
  /// The group is the entry's mirror image (P32, P43, P65).
  bool mirrored = false;
  /// How the points were chosen: a name of ref::families(), or of one of the rules of draw.cpp.
  std::string family;
  ref::Matrix gram{0};
  std::vector<ref::Isometry> generators;
  std::vector<ref::Vector> points;
  /// Any invertible affine map {B|o}; reflections are mirror images.
  ref::Isometry coordinates{ref::Matrix(0), ref::Vector(0)};
  /// name_only is in force only where the coordinates and the generators are the catalogue's.
  Naming naming = Naming::name_only;
  /// The name or alias that the file has; empty: name_of. Not in force where the file has the name only and
  /// this one would mean the mirror image.
  std::string alias;
  /// A number from which a property makes choices of its own (a permutation, a subgroup).
  std::uint64_t choice = 0;

  [[nodiscard]] int dimension() const { return entry->dimension; }
};

/// The entry's name, or the mirror image's alias: with it alone an instance has the right group.
std::string name_of(const Specimen& specimen);
/// The catalogue's generators of name_of(specimen).
const std::vector<ref::Isometry>& catalogue_generators(const Specimen& specimen);

/// Does the name mean the mirror image of the entry where no generators are given?
bool means_mirror_image(const ref::CatalogueEntry& entry, const std::string& name);

/// A specimen of a manifold, by name or alias, without points: catalogue metric, generators and coordinates.
/// Requires: the name exists.
Specimen empty_specimen(const std::string& manifold);

/// The instance of a specimen: linear parts B^-1 R B, Gram matrix B^T G B, points B^-1 (x - o).
ref::Instance instance_of(const Specimen& specimen);
/// A specimen with this instance; ref's analysis finds the catalogue coordinates.
/// Errors: as ref::analyse.
Specimen specimen_of(const ref::Instance& instance);

/// The instance file, after a comment line with family and choice.
std::ostream& operator<<(std::ostream& out, const Specimen& specimen);
/// Reads what operator<< wrote, and any instance file (choice 0 if no comment says otherwise).
/// Errors: as ref::parse_instance and ref::analyse.
Specimen read_specimen(const std::string& text, const std::string& file_name);

}  // namespace flatdt::testing
