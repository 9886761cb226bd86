/// RapidCheck generators of specimens, of what they consist of, and of triangulated specimens. They are valid
/// by construction (nothing is discarded), shrink to few points with short rationals on a simple manifold
/// with its canonical metric, and print as files or as sections of files. Example:
///   rc::check([] {
///     const Specimen s = *specimens({.manifolds = manifolds_of_the_plane()}).as("instance");
///     const std::string instance = ref::write_instance(instance_of(s));
///     RC_ASSERT(explain(instance, my_triangulation(instance)).empty());   // flatdt/testing/explain.hpp
///   });
#pragma once

#include <rapidcheck.h>

#include <iosfwd>
#include <string>
#include <vector>

#include "flatdt/ref/triangulation_format.hpp"
#include "flatdt/testing/draw.hpp"

namespace flatdt::testing {

rc::Gen<Specimen> specimens(const Domain& domain);

/// A specimen with the reference's triangulation of it.
struct TriangulatedSpecimen {
  Specimen specimen;
  ref::Triangulation triangulation;
};
/// Both files, the second after a line "# triangulation".
std::ostream& operator<<(std::ostream& out, const TriangulatedSpecimen& both);

/// Errors of the reference surface as failures of the property that draws.
rc::Gen<TriangulatedSpecimen> triangulated_specimens(const Domain& domain);

/// The group of a manifold, by generators in some affine basis, with an invariant metric.
struct Group {
  std::string manifold;  ///< a name that ref::find_entry knows
  std::vector<ref::Isometry> generators;
  ref::Matrix gram{0};
};
/// The sections of an instance file before the points.
std::ostream& operator<<(std::ostream& out, const Group& group);
rc::Gen<Group> groups(const Domain& domain);

/// A Gram matrix that the catalogue's group of a manifold preserves.
struct Metric {
  ref::Matrix gram{0};
};
/// The metric section of an instance file.
std::ostream& operator<<(std::ostream& out, const Metric& metric);
/// Canonical, random, nearly canonical (by 2^-10 to 2^-70) and stretched metrics, in catalogue coordinates.
/// Requires: ref::find_entry knows the name, max_stretch >= 1.   Errors: std::invalid_argument for the name.
rc::Gen<Metric> metrics(const std::string& manifold, long max_stretch = 1);

/// Points in catalogue coordinates; two of them may lie in one orbit.
struct PointSet {
  std::vector<ref::Vector> points;
};
/// The points section of an instance file.
std::ostream& operator<<(std::ostream& out, const PointSet& set);
/// One to max_points points by all rules of point_rules().
/// Requires, Errors: as metrics(); max_points >= 1.
rc::Gen<PointSet> point_sets(const std::string& manifold, long max_points);

}  // namespace flatdt::testing
