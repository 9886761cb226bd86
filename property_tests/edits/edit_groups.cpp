/// Edits of the instance's group and of the name it claims: the cells glued into a wrong manifold.
#include <algorithm>

#include "draft.hpp"
#include "flatdt/ref/catalogue.hpp"

namespace flatdt::edits {

using Name = checker::ConditionName;
using ref::Isometry;
using ref::Rational;
using ref::Vector;

namespace {

std::optional<Files> wrong_name(const Base& base, Random& random) {
  if (!base.instance().name) return std::nullopt;
  const ref::CatalogueEntry* own = ref::find_entry(*base.instance().name);
  std::vector<std::string> others;
  for (const ref::CatalogueEntry& entry : ref::catalogue())
    if (entry.dimension == base.dimension() && &entry != own) others.push_back(entry.name);
  Draft draft(base);
  draft.set_generators(base.instance().generators);
  draft.instance().name = random.choice(others);
  return draft.files();
}

/// The point reflection in a point of the instance's coordinates: it preserves every metric and normalises
/// the lattice, so with it the group stays discrete, but it has a fixed point.
std::optional<Files> with_fixed_point(const Base& base, Random& random) {
  Draft draft(base);
  std::vector<Isometry> generators = base.instance().generators;
  generators.push_back(
      {Rational(-1) * ref::Matrix::identity(base.dimension()), random.choice(base.instance().points)});
  draft.set_generators(generators);
  return draft.files();
}

std::optional<Files> too_few_translations(const Base& base, Random& random) {
  Draft draft(base);
  std::vector<Isometry> generators;
  const int left_out = random.between(0, base.dimension() - 1);
  for (int j = 0; j < base.dimension(); ++j)
    if (j != left_out) generators.push_back(Isometry::translate(base.group().lattice().column(j)));
  draft.instance().name.reset();
  draft.set_generators(generators);
  return draft.files();
}

/// The files with another group, without a name, if some element of the triangulation is not in it.
std::optional<Files> glued_otherwise(const Base& base, const std::vector<Isometry>& generators) {
  const CrystalGroup other(base.instance().gram, generators);
  const std::vector<Isometry>& elements = base.triangulation().elements;
  if (std::all_of(elements.begin(), elements.end(), [&](const Isometry& g) { return other.contains(g); }))
    return std::nullopt;
  Draft draft(base);
  draft.instance().name.reset();
  draft.set_generators(generators);
  return draft.files();
}

std::vector<Isometry> translations(const CrystalGroup& group, int factor) {
  std::vector<Isometry> all;
  for (int j = 0; j < group.lattice().dimension(); ++j)
    all.push_back(Isometry::translate(Rational(j == 0 ? factor : 1) * group.lattice().column(j)));
  return all;
}

std::optional<Files> torus_of_the_lattice(const Base& base, Random& /*random*/) {
  return base.group().cosets().size() == 1 ? std::nullopt
                                           : glued_otherwise(base, translations(base.group(), 1));
}

std::optional<Files> torus_of_a_sublattice(const Base& base, Random& random) {
  return glued_otherwise(base, translations(base.group(), random.between(2, 3)));
}

std::optional<Files> origin_moved(const Base& base, Random& random) {
  Vector by(base.dimension());
  for (int k = 0; k < base.dimension(); ++k)
    by[k] = Rational(ref::Integer(random.between(-3, 3)), ref::Integer(7));
  const Isometry move = Isometry::translate(by);
  std::vector<Isometry> generators;
  for (const Isometry& g : base.instance().generators) generators.push_back(move * g * move.inverse());
  return glued_otherwise(base, generators);
}

/// P3_1 for P3_2 and the like: the mirror image in the plane of the first two coordinates.
std::optional<Files> other_hand(const Base& base, Random& /*random*/) {
  if (base.dimension() != 3 || base.group().cosets().size() == 1) return std::nullopt;
  ref::Matrix mirror = ref::Matrix::identity(3);
  mirror(2, 2) = Rational(-1);
  if (mirror.transpose() * base.instance().gram * mirror != base.instance().gram) return std::nullopt;
  std::vector<Isometry> generators;
  for (const Isometry& g : base.instance().generators) {
    const Isometry s{mirror, Vector(3)};
    generators.push_back(s * g * s);
  }
  return glued_otherwise(base, generators);
}

/// The torus' cells in a manifold that the torus covers: all elements belong, but the volume is a multiple.
std::optional<Files> larger_group(const Base& base, Random& random) {
  if (!base.on_manifold() || base.group().cosets().size() > 1) return std::nullopt;
  if (!base.group().lattice().is_identity()) return std::nullopt;
  std::vector<const ref::CatalogueEntry*> covered;
  for (const ref::CatalogueEntry& entry : ref::catalogue()) {
    if (entry.dimension != base.dimension() || entry.holonomy_order == 1) continue;
    const bool invariant =
        std::all_of(entry.generators.begin(), entry.generators.end(), [&](const Isometry& g) {
          return g.linear.transpose() * base.instance().gram * g.linear == base.instance().gram;
        });
    if (invariant) covered.push_back(&entry);
  }
  if (covered.empty()) return std::nullopt;
  Draft draft(base);
  draft.instance().name.reset();
  draft.set_generators(random.choice(covered)->generators);
  return draft.files();
}

}  // namespace

std::vector<Kind> group_kinds() {
  const Expectation outside = breaks({Name::subgroup_member});
  const std::string_view listed = "a listed element is not in the new group";
  return {
      {"wrong name", "the group is another one", breaks({Name::group_name}), wrong_name},
      {"generator with a fixed point added", "a point reflection fixes a point",
       breaks({Name::group_torsion_free}), with_fixed_point},
      {"group with too few translations", "the quotient is not compact",
       breaks({Name::group_crystallographic}), too_few_translations},
      {"cells glued into the torus of the lattice", listed, outside, torus_of_the_lattice},
      {"cells glued into the torus of a sublattice", listed, outside, torus_of_a_sublattice},
      {"origin of the group moved", listed, outside, origin_moved},
      {"group of the other hand", listed, outside, other_hand},
      {"torus glued into a manifold that it covers", "the volumes are a multiple of that of the space",
       breaks({Name::volume_exact}), larger_group},
  };
}

}  // namespace flatdt::edits
