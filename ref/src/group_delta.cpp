/// delta(G)^2: the square of the least distance by which an element but the identity moves a point.
#include <algorithm>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"
#include "group_parts.hpp"
#include "group_plane.hpp"

namespace flatdt::ref {
namespace {

/// Basis of the lattice of all P l, l in Z^d.
std::vector<Vector> projected_lattice(const Matrix& projection) {
  HermiteBasis lattice(projection.dimension());
  for (int j = 0; j < projection.dimension(); ++j) lattice.add(projection.column(j));
  return lattice.vectors();
}

/// Least |v + k b|^2 over integers k.
Rational nearest_on_line(const Matrix& gram, const Vector& v, const Vector& b) {
  const Rational k = -inner_product(gram, v, b) / squared_length(gram, b);
  return squared_length(gram, v + Rational(round_half_up(k)) * b);
}

/// Least |v + l| squared over the lattice vectors l of a plane. Requires: v in the plane.
Rational nearest_on_plane(const Matrix& gram, const Vector& v, const std::vector<Vector>& b) {
  return squared_length(gram, v - PlaneLattice(gram, b[0], b[1]).closest_to(v));
}

}  // namespace

/// |x - {R|s}x|^2 is least where x - {R|s}x = -P_R s: the component of s along ker(R - I) moves every point
/// alike, and x can be chosen so that the rest vanishes, because I - R is invertible on its image.
Rational delta_squared(const WorkingGroup& group) {
  Rational least = shortest_squared_length(group.gram);
  for (const Isometry& coset : group.cosets) {
    if (coset.linear.is_identity()) continue;
    const CyclicSum cyclic = cyclic_sum(coset.linear);
    const Matrix projection = Rational(Integer(1), Integer(cyclic.order)) * cyclic.sum;
    const Vector screw = projection * coset.translation;
    const std::vector<Vector> lattice = projected_lattice(projection);
    ensure(lattice.size() == 1 || lattice.size() == 2, "a torsion-free group has no R without a fixed axis");
    const Rational distance = lattice.size() == 1 ? nearest_on_line(group.gram, screw, lattice[0])
                                                  : nearest_on_plane(group.gram, screw, lattice);
    ensure(!distance.is_zero(), "an element of a torsion-free group moves every point");
    least = std::min(least, distance);
  }
  return least;
}

}  // namespace flatdt::ref
