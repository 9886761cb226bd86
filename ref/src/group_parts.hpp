/// The steps of analyse(), one source file each (group_*.cpp).
/// Coordinates: "instance" are those of the input; "working" are those of a reduced basis of the translation
/// lattice, in which the lattice is Z^d and every linear part is an integral matrix with small entries.
/// Invariants: every result is a function of the group and the metric, not of the generators given.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::ref {

/// A crystallographic group: its translation lattice and one representative of each coset.
struct CosetGroup {
  Matrix lattice;                // Hermite normal form, columns (working coordinates: the identity)
  std::vector<Isometry> cosets;  // the identity first, then by linear part; translations reduced
};

/// The same group in working coordinates: x_instance = basis * x_working.
struct WorkingGroup {
  Matrix basis;
  Matrix gram;
  std::vector<Isometry> cosets;
};

/// Text for messages, cut where hostile numbers make it long.
std::string shown(const std::string& text);

/// t minus the lattice vector that puts it into the canonical fundamental domain.
/// Requires: lattice in Hermite normal form (lower triangular, positive diagonal).
Vector reduced_modulo(const Matrix& lattice, Vector t);
/// Reduces translations and sorts: the identity first, then by linear part.
void make_canonical(const Matrix& lattice, std::vector<Isometry>& cosets);

/// Errors: InvalidInput naming the leading minor that is not positive.
void check_metric(const Matrix& gram);
/// Closes the generators. Errors: as analyse(), up to cocompactness.
CosetGroup close_group(const std::vector<Isometry>& generators, const Matrix& gram);
WorkingGroup working_group(const CosetGroup& group, const Matrix& gram);

/// The order m of an integral matrix of finite order and I + R + ... + R^(m-1) = m P_R.
struct CyclicSum {
  int order;
  Matrix sum;
};
CyclicSum cyclic_sum(const Matrix& linear);

/// An element other than the identity, and a point that it fixes.
struct FixedPoint {
  Isometry element;
  Vector point;
};
/// The first coset of the list that contains an element of finite order, with such an element.
std::optional<FixedPoint> find_fixed_point(const WorkingGroup& group);

/// "1", "Z2", "Z3", "Z4", "Z6" or "Z2xZ2". Requires: torsion-free, so one of these.
std::string holonomy_name(const WorkingGroup& group);
bool is_orientable(const std::vector<Isometry>& cosets);
Homology first_homology(const WorkingGroup& group);
const CatalogueEntry& recognise(const WorkingGroup& group);
Rational delta_squared(const WorkingGroup& group);

/// x_working = axes * x_catalogue + origin; in catalogue coordinates the group is that of the entry or, if
/// mirrored, its mirror image.
struct CatalogueMap {
  Matrix axes;
  Vector origin;
  bool mirrored;
};
/// The axes that the geometry of the group's type allows, best first; the last step of recognition takes the
/// first for which an origin exists. `orientation` is the sign of det(working basis).
struct AxesCandidate {
  Matrix axes;
  bool mirrored;
};
std::vector<AxesCandidate> axes_candidates(const WorkingGroup& group, const CatalogueEntry& entry,
                                           Sign orientation);
/// Coset representatives of the entry or of its mirror image, in catalogue coordinates, canonical.
std::vector<Isometry> catalogue_cosets(const CatalogueEntry& entry, bool mirrored);
Frame make_frame(const CosetGroup& group, const WorkingGroup& working, const CatalogueEntry& entry,
                 const Matrix& gram);

/// A basis of {v in Z^d : m v = 0}. Requires: m integral.
std::vector<Vector> kernel_basis(const Matrix& m);
/// Some l in Z^d with m l = rhs, if there is one. Requires: m integral.
std::optional<Vector> solve_integral(const Matrix& m, const Vector& rhs);
/// Some x with a[k] x = r[k] modulo Z^d for all k, if there is one. Requires: a[k] integral.
std::optional<Vector> solve_congruences(const std::vector<Matrix>& a, const std::vector<Vector>& r);

}  // namespace flatdt::ref
