/// One point set of one manifold, given in different ways, has one Delaunay tessellation: other orders of the
/// points, other representatives, other coordinates, isometries, mirror images, scales, subgroups. The
/// triangulation itself is a function of the points of the manifold, and byte for byte the same where
/// docs/theory.md, section 5, says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "for_all.hpp"
#include "judge.hpp"
#include "metrics.hpp"
#include "quotient.hpp"
#include "random.hpp"
#include "require.hpp"
#include "subgroups.hpp"

namespace flatdt::property_tests {
namespace {

using testing::Random;

/// An instance triangulated, and what it says modulo the group of the specimen.
struct Outcome {
  Outcome(const Specimen& s, const ref::TriangulationOptions& options = {})
      : Outcome(s, instance_of(s), s.coordinates, options) {}
  /// `instance`: of a subgroup of the specimen's group, in coordinates that `to_catalogue` takes to it.
  Outcome(const Specimen& s, ref::Instance of_instance, const Isometry& to_catalogue,
          const ref::TriangulationOptions& options = {})
      : instance(std::move(of_instance)),
        result(triangulate(instance, options)),
        corners(corners_of(instance, result.triangulation, to_catalogue)),
        quotient(s),
        folded(fold(quotient, corners)),
        tessellation(tessellate(quotient, s.gram, folded)) {}

  [[nodiscard]] std::string bytes() const {
    return write_triangulation(result.triangulation, describe(result));
  }

  ref::Instance instance;
  ref::TriangulationResult result;
  std::vector<CellCorners> corners;
  Quotient quotient;
  Folded folded;
  Tessellation tessellation;
};

void require_same_tessellation(const Specimen& s, const Outcome& a, const Outcome& b) {
  require(a.tessellation == b.tessellation, "the Delaunay tessellations differ");
  if (has_ties(a.tessellation, s.dimension())) return;
  require(a.folded.cells == b.folded.cells, "the triangulations differ, without ties");
  require(a.result.sheets == b.result.sheets, "one answer is on the manifold, the other is not");
}

/// The first point of each orbit only.
Specimen without_repetitions(const Specimen& s) {
  const Quotient quotient(s);
  std::set<Vector> orbits;
  Specimen t = s;
  t.points.clear();
  for (const Vector& x : s.points)
    if (orbits.insert(quotient.canonical(x).point).second) t.points.push_back(x);
  return t;
}

void any_order_seed(const Specimen& s) {
  const ref::Instance instance = instance_of(s);
  const auto bytes = [&](const ref::TriangulationOptions& options) {
    const auto result = triangulate(instance, options);
    return write_triangulation(result.triangulation, describe(result));
  };
  ref::TriangulationOptions other;
  other.order_seed = s.choice + 1;
  require(bytes({}) == bytes(other), "the bytes depend on the insertion order");
}

void any_working_cover(const Specimen& s) {
  ref::TriangulationOptions theorem10;
  theorem10.insertion = ref::Insertion::covering;
  theorem10.cover = ref::CoverChoice::theorem10;
  theorem10.max_sheets = 1'000'000;
  require(Outcome(s).bytes() == Outcome(s, theorem10).bytes(), "the bytes depend on the cover worked in");
}

void permuted_points(const Specimen& given) {
  const Specimen s = without_repetitions(given);
  std::vector<std::uint32_t> new_index(s.points.size());
  std::iota(new_index.begin(), new_index.end(), 0U);
  Random random(s.choice);
  random.shuffle(new_index);
  Specimen t = s;
  for (std::size_t i = 0; i < new_index.size(); ++i) t.points[new_index[i]] = s.points[i];
  auto a = triangulate(instance_of(s)).triangulation;
  const auto b = triangulate(instance_of(t)).triangulation;
  for (auto& cell : a.cells)
    for (std::size_t k = 0; k <= static_cast<std::size_t>(s.dimension()); ++k)
      cell[k].point = new_index[cell[k].point];
  require(write_triangulation(a, {}) == write_triangulation(b, {}),
          "the bytes depend on the order of the points");
}

void other_representatives(const Specimen& s) {
  const Quotient quotient(s);
  Random random(s.choice);
  Specimen t = s;
  for (Vector& x : t.points) {
    Vector shift(s.dimension());
    for (int i = 0; i < s.dimension(); ++i) shift[i] = random.between(-40, 40);
    x = random.of(quotient.cosets()) * x + shift;
  }
  const Outcome a(s), b(t);
  // The same lifts of the same cells in the same order; only the elements are written differently.
  require(a.corners == b.corners, "the triangulation depends on the representatives of the orbits");
  require(a.result.sheets == b.result.sheets, "the answer depends on the representatives of the orbits");
}

void scaled(const Specimen& s) {
  Specimen t = s;
  Random random(s.choice);
  t.gram = random.fraction(1, 1000, random.between(1, 1000)) * s.gram;
  require(Outcome(s).bytes() == Outcome(t).bytes(), "the bytes depend on the unit of length");
}

/// Another basis of determinant 1 or -1 and another origin: the same points of the same space.
void other_coordinates(const Specimen& s) {
  Random random(s.choice);
  Matrix basis = Matrix::identity(s.dimension());
  for (int round = 0; round < 3; ++round) {
    Matrix shear = Matrix::identity(s.dimension());
    const int i = static_cast<int>(random.below(static_cast<std::uint64_t>(s.dimension())));
    shear(i, (i + 1) % s.dimension()) = random.between(-3, 3);
    basis = basis * shear;
  }
  if (random.one_in(2)) basis.set_column(0, -basis.column(0));
  Specimen t = s;
  Vector origin(s.dimension());
  for (int i = 0; i < s.dimension(); ++i) origin[i] = random.fraction(-50, 50, random.between(1, 9));
  t.coordinates = s.coordinates * Isometry{basis, origin};
  t.naming = testing::Naming::generators_only;
  require_same_tessellation(s, Outcome(s), Outcome(t));
}

/// The point reflection and a translation are isometries of every metric; in space a reflection is a mirror
/// image. The group becomes a conjugate one, the metric stays.
void moved_by_an_isometry(const Specimen& s) {
  Random random(s.choice);
  Isometry motion = Isometry::identity(s.dimension());
  if (random.one_in(2)) motion.linear = Rational(-1) * motion.linear;
  for (int i = 0; i < s.dimension(); ++i) motion.translation[i] = random.fraction(-60, 60, 7);
  Specimen t = s;
  t.coordinates = s.coordinates * motion.inverse();
  t.naming = testing::Naming::generators_only;
  require(instance_of(t).gram == instance_of(s).gram, "an isometry keeps the metric");
  require_same_tessellation(s, Outcome(s), Outcome(t));
}

/// A mirror image in the first coordinate: any metric, another Gram matrix.
void mirrored(const Specimen& s) {
  Specimen t = s;
  Isometry mirror = Isometry::identity(s.dimension());
  mirror.linear(0, 0) = -1;
  t.coordinates = s.coordinates * mirror;
  t.naming = testing::Naming::name_and_generators;
  require_same_tessellation(s, Outcome(s), Outcome(t));
}

/// The points of E^d are the same for a subgroup of finite index, with representatives for each coset.
void passed_to_a_subgroup(const Specimen& s) {
  const SubgroupInstance sub = draw_subgroup(s, s.dimension() == 2 ? 8 : 3, s.choice);
  const Outcome a(s), b(s, sub.instance, s.coordinates);
  require_verified(sub.instance, b.result.triangulation);
  require(b.result.distinct_points == sub.index * a.result.distinct_points,
          "an orbit of the group is [G:H] orbits of the subgroup");
  require(a.tessellation == b.tessellation, "the tessellations of group and subgroup differ");
  if (!has_ties(a.tessellation, s.dimension()))
    require(a.folded.cells == b.folded.cells,
            "the triangulations of group and subgroup differ, without ties");
}

TEST(Metamorphic, AnyOrderSeedInThePlane) {
  for_all({60, plane()}, any_order_seed);
}
TEST(Metamorphic, AnyOrderSeedInSpace) {
  for_all({6, space()}, any_order_seed);
}
TEST(Metamorphic, AnyWorkingCover) {
  for_all({40, plane()}, any_working_cover);
}
TEST(Metamorphic, PermutedPointsInThePlane) {
  for_all({60, plane()}, permuted_points);
}
TEST(Metamorphic, PermutedPointsInSpace) {
  for_all({6, space()}, permuted_points);
}
TEST(Metamorphic, OtherRepresentativesInThePlane) {
  for_all({40, plane()}, other_representatives);
}
TEST(Metamorphic, OtherRepresentativesInSpace) {
  for_all({6, space()}, other_representatives);
}
TEST(Metamorphic, ScaledInThePlane) {
  for_all({40, plane()}, scaled);
}
TEST(Metamorphic, ScaledInSpace) {
  for_all({6, space()}, scaled);
}
TEST(Metamorphic, OtherCoordinatesInThePlane) {
  for_all({40, plane()}, other_coordinates);
}
TEST(Metamorphic, OtherCoordinatesInSpace) {
  for_all({6, space()}, other_coordinates);
}
TEST(Metamorphic, MovedByAnIsometryInThePlane) {
  for_all({40, plane()}, moved_by_an_isometry);
}
TEST(Metamorphic, MovedByAnIsometryInSpace) {
  for_all({6, space()}, moved_by_an_isometry);
}
TEST(Metamorphic, MirroredInThePlane) {
  for_all({40, plane()}, mirrored);
}
TEST(Metamorphic, MirroredInSpace) {
  for_all({6, space()}, mirrored);
}
TEST(Metamorphic, PassedToASubgroupInThePlane) {
  for_all({60, plane()}, passed_to_a_subgroup);
}
TEST(Metamorphic, PassedToASubgroupInSpace) {
  Domain domain = space();
  domain.max_points_in_space = 2;
  for_all({6, domain}, passed_to_a_subgroup);
}

}  // namespace
}  // namespace flatdt::property_tests
