/// Catalogue axes from the geometry of each type: lattice vectors in ker(R - I) and ker(R + I).
/// Choices are made by length and then by working coordinates, so they depend on group and metric only. That
/// the axes fit is not assumed anywhere: make_frame() verifies the group in their coordinates.
#include <algorithm>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"
#include "group_parts.hpp"
#include "group_plane.hpp"

namespace flatdt::ref {
namespace {

Matrix columns(const std::vector<Vector>& vectors) {
  Matrix m(vectors[0].dimension());
  for (std::size_t j = 0; j < vectors.size(); ++j) m.set_column(static_cast<int>(j), vectors[j]);
  return m;
}

/// v or -v: the one whose first nonzero coordinate is positive.
Vector with_sign(const Vector& v) {
  return v < Vector(v.dimension()) ? -v : v;
}

/// Reduced basis of the lattice vectors v with m v = 0; its rank is 1 or 2.
std::vector<Vector> reduced_kernel(const Matrix& gram, const Matrix& m) {
  std::vector<Vector> basis = kernel_basis(m);
  if (basis.size() == 2) {
    const PlaneLattice plane(gram, basis[0], basis[1]);
    const Matrix t = reduce_basis(plane.gram()).transform;
    basis = {plane.at(t.column(0)), plane.at(t.column(1))};
  }
  for (Vector& v : basis) v = with_sign(v);
  return basis;
}
std::vector<Vector> fixed_by(const Matrix& gram, const Matrix& linear) {
  return reduced_kernel(gram, linear - Matrix::identity(gram.dimension()));
}
std::vector<Vector> reversed_by(const Matrix& gram, const Matrix& linear) {
  return reduced_kernel(gram, linear + Matrix::identity(gram.dimension()));
}

/// Klein bottle, L = Z a + Z b: the reflection reverses a and fixes b. (A reflection exchanging two basis
/// vectors belongs to the group cm, which has mirrors.)
Matrix klein_bottle_axes(const WorkingGroup& group) {
  const Matrix& r = group.cosets[1].linear;
  return columns({reversed_by(group.gram, r)[0], fixed_by(group.gram, r)[0]});
}

/// Dicosm, L = (Z a + Z b) + Z c: the half turn reverses a, b and fixes c. (If L were larger than the sum,
/// its projection to the axis would contain c/2, and the class of the screw an element with a fixed point.)
Matrix dicosm_axes(const WorkingGroup& group) {
  const Matrix& r = group.cosets[1].linear;
  const auto plane = reversed_by(group.gram, r);
  return columns({plane[0], plane[1], fixed_by(group.gram, r)[0]});
}

/// Tri-, tetra- and hexacosm: c along the axis; R the linear part of the screw by c/n, n = 3, 4, 6; a a
/// shortest vector of the plane lattice, and b = R a, or R^2 a for n = 6, where the catalogue's angle is 120
/// degrees. In these axes R is the catalogue's matrix, so the sense of rotation is in the sign of the
/// determinant: if the axes are left-handed, -c makes them right-handed and the group the mirror image.
AxesCandidate screw_axes(const WorkingGroup& group, Sign orientation) {
  const auto n = static_cast<int>(group.cosets.size());
  const Vector c = fixed_by(group.gram, group.cosets[1].linear)[0];
  const Rational length = squared_length(group.gram, c);
  for (const Isometry& coset : group.cosets) {
    const CyclicSum cyclic = cyclic_sum(coset.linear);
    if (cyclic.order != n) continue;
    // n P t = k c with k a unit modulo n, because P L = Z c.
    const Rational k = inner_product(group.gram, cyclic.sum * coset.translation, c) / length;
    ensure(k.is_integer(), "the n-th power of a screw is a translation along its axis");
    if (floor_mod(k.numerator(), Integer(n)) != Integer(1)) continue;
    const Vector a = with_sign(reduced_kernel(group.gram, cyclic.sum)[0]);
    const Vector b = n == 6 ? coset.linear * (coset.linear * a) : coset.linear * a;
    const bool mirrored = columns({a, b, c}).determinant().sign() * orientation == Sign::negative;
    return {columns({a, b, mirrored ? -c : c}), mirrored};
  }
  throw InternalError("a cyclic group of screws contains the one by the least distance");
}

/// Didicosm, L = Z a + Z b + Z c: the axes of the three screws, in every order.
std::vector<AxesCandidate> didicosm_axes(const WorkingGroup& group) {
  std::vector<Vector> axes;
  for (std::size_t k = 1; k < group.cosets.size(); ++k)
    axes.push_back(fixed_by(group.gram, group.cosets[k].linear)[0]);
  std::sort(axes.begin(), axes.end());
  std::vector<AxesCandidate> candidates;
  do {
    candidates.push_back({columns(axes), false});
  } while (std::next_permutation(axes.begin(), axes.end()));
  return candidates;
}

/// Amphidicosms, L = Z a + Z b + Z c: c the axis of the screw, a and b the normals of the two glides, in
/// either order.
std::vector<AxesCandidate> amphidicosm_axes(const WorkingGroup& group) {
  std::vector<Vector> normals, axis;
  for (std::size_t k = 1; k < group.cosets.size(); ++k) {
    const Matrix& r = group.cosets[k].linear;
    if (r.determinant().sign() == Sign::positive)
      axis = fixed_by(group.gram, r);
    else
      normals.push_back(reversed_by(group.gram, r)[0]);
  }
  ensure(normals.size() == 2 && axis.size() == 1, "an amphidicosm has one screw and two glides");
  return {{columns({normals[0], normals[1], axis[0]}), false},
          {columns({normals[1], normals[0], axis[0]}), false}};
}

/// First amphicosm, L = M + Z b, M the lattice in the mirror plane: the glide is c/2 modulo M for a c in M
/// outside 2M. The shortest c of its class modulo 2M is primitive (c = k c' with k odd puts c' in the class).
Matrix first_amphicosm_axes(const WorkingGroup& group) {
  const Isometry& glide = group.cosets[1];
  const auto m = fixed_by(group.gram, glide.linear);
  const PlaneLattice plane(group.gram, m[0], m[1]);
  const Vector square = glide.linear * glide.translation + glide.translation;
  const Vector c = square - Rational(2) * plane.closest_to(Rational(Integer(1), Integer(2)) * square);
  return columns({with_sign(plane.shortest_completion(c)), reversed_by(group.gram, glide.linear)[0], c});
}

/// Second amphicosm: L contains M + Z d with index 2, d the normal; the other half is a + M + Z d with
/// a - R a = d and a + R a = s in M, s outside 2M and fixed modulo 2M. The shortest s of its class is
/// primitive, as above; with any c completing it, a = (s + d)/2, b = R a = (s - d)/2 and c are a basis of L.
/// The glide is half a vector of M that is neither 0 nor s modulo 2M (else a mirror), so c or c + s, and
/// {R|(c + s)/2} = {R|c/2} with another origin, up to the translation a.
Matrix second_amphicosm_axes(const WorkingGroup& group) {
  const Matrix& r = group.cosets[1].linear;
  const auto m = fixed_by(group.gram, r);
  const PlaneLattice plane(group.gram, m[0], m[1]);
  const Vector d = reversed_by(group.gram, r)[0];
  // a + R a = s for a lattice vector a with a - R a = d.
  const auto a0 = solve_integral(Matrix::identity(3) - r, d);
  ensure(a0.has_value(), "the lattice of the second amphicosm is centred");
  const Rational half(Integer(1), Integer(2));
  const Vector sum = *a0 + r * *a0;
  const Vector s = with_sign(sum - Rational(2) * plane.closest_to(half * sum));
  const Vector c = with_sign(plane.shortest_completion(s));
  return columns({half * (s + d), half * (s - d), c});
}

}  // namespace

std::vector<AxesCandidate> axes_candidates(const WorkingGroup& group, const CatalogueEntry& entry,
                                           Sign orientation) {
  if (entry.holonomy_order == 1) return {{Matrix::identity(entry.dimension), false}};
  if (entry.name == "klein-bottle") return {{klein_bottle_axes(group), false}};
  if (entry.name == "dicosm") return {{dicosm_axes(group), false}};
  if (entry.name == "first-amphicosm") return {{first_amphicosm_axes(group), false}};
  if (entry.name == "second-amphicosm") return {{second_amphicosm_axes(group), false}};
  if (entry.name == "didicosm") return didicosm_axes(group);
  if (entry.holonomy == "Z2xZ2") return amphidicosm_axes(group);
  return {screw_axes(group, orientation)};
}

}  // namespace flatdt::ref
