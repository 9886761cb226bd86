/// Edits of the covering: subgroups too small, too large or not in the group, and sheets that are missing.
#include <algorithm>

#include "checkerboard.hpp"
#include "flip.hpp"

namespace flatdt::edits {

using Name = checker::ConditionName;
using ref::Isometry;
using ref::Rational;
using ref::Vector;

namespace {

/// A subgroup of translations of H, of finite index, and elements that represent its right cosets in H.
struct Sublattice {
  std::vector<Isometry> generators;
  std::vector<Isometry> cosets;
};

/// The sublattice of H whose basis is that of H's lattice with one vector multiplied, and perhaps sheared.
Sublattice sublattice(const CrystalGroup& h, Random& random, int factor) {
  Sublattice s;
  const int d = h.lattice().dimension();
  const int along = random.between(0, d - 1);
  const int other = (along + random.between(0, d - 1)) % d;
  for (int j = 0; j < d; ++j) {
    Vector v = h.lattice().column(j);
    if (j == along) v = Rational(factor) * v;
    // A shear by a smaller multiple of the vector that is multiplied: the lattice is then not a product.
    if (j == other && other != along)
      v = v + Rational(random.between(0, factor - 1)) * h.lattice().column(along);
    s.generators.push_back(Isometry::translate(v));
  }
  for (int k = 0; k < factor; ++k)
    for (const Isometry& r : h.cosets())
      s.cosets.push_back(Isometry::translate(Rational(k) * h.lattice().column(along)) * r);
  return s;
}

/// The subgroup that one element of H and 2L generate, L the lattice of H: 2L is invariant under the linear
/// parts, so its lattice is between 2L and L. It need not be normal.
std::vector<Isometry> with_one_element(const CrystalGroup& h, Random& random) {
  std::vector<Isometry> generators = {h.element(random, 1)};
  for (int j = 0; j < h.lattice().dimension(); ++j)
    generators.push_back(Isometry::translate(Rational(2) * h.lattice().column(j)));
  return generators;
}

/// The cells of the base, each moved by all coset representatives, as a triangulation of E^d modulo the
/// subgroup.
Draft unfolded(const Base& base, const std::vector<Isometry>& generators,
               const std::vector<Isometry>& cosets) {
  Draft draft(base);
  draft.cells().clear();
  for (const FileCell& cell : base.triangulation().cells)
    for (const Isometry& r : cosets) draft.cells().push_back(draft.moved(r, cell));
  draft.triangulation().has_subgroup = true;
  draft.triangulation().subgroup = generators;
  return draft;
}

void claim_space_of(const Base& base, Draft& draft) {
  draft.triangulation().has_subgroup = base.triangulation().has_subgroup;
  draft.triangulation().subgroup = base.triangulation().subgroup;
}

constexpr std::size_t kMostCells = 1600;

std::optional<Draft> unfolded_once(const Base& base, Random& random, std::size_t* sheets = nullptr) {
  const int factor = random.between(2, 3);
  const Sublattice s = sublattice(base.subgroup(), random, factor);
  if (base.cell_count() * s.cosets.size() > kMostCells) return std::nullopt;
  if (sheets != nullptr) *sheets = s.cosets.size();
  return unfolded(base, s.generators, s.cosets);
}

std::optional<Files> unfold(const Base& base, Random& random) {
  const std::optional<Draft> draft = unfolded_once(base, random);
  return draft ? std::optional(draft->files()) : std::nullopt;
}

std::optional<Files> unfold_with_holonomy(const Base& base, Random& random) {
  if (base.subgroup().cosets().size() < 2) return std::nullopt;
  std::vector<Isometry> generators;
  do generators = with_one_element(base.subgroup(), random);
  while (generators.front().linear.is_identity());
  const CrystalGroup k(base.instance().gram, generators);
  const std::vector<Isometry> cosets = base.subgroup().right_cosets(k);
  if (base.cell_count() * cosets.size() > kMostCells) return std::nullopt;
  return unfolded(base, generators, cosets).files();
}

std::optional<Files> cover_claimed_as_its_base(const Base& base, Random& random) {
  std::optional<Draft> draft = unfolded_once(base, random);
  if (!draft) return std::nullopt;
  claim_space_of(base, *draft);
  return draft->files();
}

/// Two copies of every cell in a connected double cover, where a tie is decided differently in one sheet:
/// then claimed for what it covers.
std::optional<Files> double_cover(const Base& base, Random& random) {
  const CrystalGroup& h = base.subgroup();
  if (h.cosets().size() > 1 || base.ties().empty() || 2 * base.cell_count() > kMostCells) return std::nullopt;
  const Sublattice s = sublattice(h, random, 2);
  const Base cover(unfolded(base, s.generators, s.cosets).data(), base.label() + " doubled");
  Draft draft(cover);
  for (const std::size_t k : random.order(cover.ties().size())) {
    const auto [c, i] = cover.ties()[k];
    const std::optional<Flip> flip = facet_flip(cover, draft, c, i);
    if (!flip) continue;
    apply(*flip, draft);
    claim_space_of(base, draft);
    return draft.files();
  }
  return std::nullopt;
}

std::optional<Files> sheet_missing(const Base& base, Random& random) {
  std::size_t sheets = 0;
  std::optional<Draft> draft = unfolded_once(base, random, &sheets);
  if (!draft) return std::nullopt;
  const std::size_t gone = random.below(sheets);
  std::vector<std::size_t> cells;
  for (std::size_t c = 0; c < base.cell_count(); ++c) cells.push_back(c * sheets + gone);
  draft->remove_cells(cells);
  return draft->files();
}

std::optional<Files> subgroup_too_small(const Base& base, Random& random) {
  Draft draft(base);
  draft.triangulation().has_subgroup = true;
  draft.triangulation().subgroup = sublattice(base.subgroup(), random, random.between(2, 5)).generators;
  return draft.files();
}

std::optional<Files> subgroup_forgotten(const Base& base, Random& /*random*/) {
  if (base.on_manifold()) return std::nullopt;
  Draft draft(base);
  draft.triangulation().has_subgroup = false;
  draft.triangulation().subgroup.clear();
  return draft.files();
}

std::optional<Files> subgroup_too_large(const Base& base, Random& random) {
  if (base.on_manifold()) return std::nullopt;
  Draft draft(base);
  const Isometry g = base.group().element(random, 1);
  if (base.subgroup().contains(g)) return std::nullopt;
  draft.triangulation().subgroup.push_back(g);
  return draft.files();
}

std::optional<Files> subgroup_outside(const Base& base, Random& random) {
  Draft draft(base);
  if (base.on_manifold()) draft.triangulation().subgroup = base.instance().generators;
  draft.triangulation().has_subgroup = true;
  const Vector v = base.group().lattice().column(random.between(0, base.dimension() - 1));
  draft.triangulation().subgroup.push_back(
      Isometry::translate(Rational(ref::Integer(1), ref::Integer(random.between(2, 9))) * v));
  return draft.files();
}

std::optional<Files> subgroup_of_infinite_index(const Base& base, Random& random) {
  Draft draft(base);
  draft.triangulation().has_subgroup = true;
  draft.triangulation().subgroup.clear();
  for (int j = 0; j < random.between(0, base.dimension() - 1); ++j)
    draft.triangulation().subgroup.push_back(Isometry::translate(base.subgroup().lattice().column(j)));
  return draft.files();
}

}  // namespace

std::vector<Kind> cover_kinds() {
  const Conditions tiles = {Name::facets_paired, Name::facets_opposite};
  const Expectation outside = breaks({Name::subgroup_member});
  const std::string_view orbits = "its cells modulo the subgroup; a covering of a simplicial complex is one";
  const std::string_view volume = "the volumes are a multiple of that of the space";
  return {
      {"unfolded to a sublattice", orbits, keeps(), unfold},
      {"unfolded to a subgroup with holonomy", orbits, keeps(), unfold_with_holonomy},
      {"cover claimed as what it covers", "every facet occurs again for every sheet",
       breaks({Name::facets_paired, Name::volume_exact}), cover_claimed_as_its_base},
      {"double cover, one tie different, claimed as what it covers",
       "the facets of cells away from the tie occur again", breaks({Name::facets_paired, Name::volume_exact}),
       double_cover},
      {"checkerboard: a connected double cover claimed as the torus",
       "every facet is paired, but the volume is doubled",
       breaks(
           {Name::volume_exact}, {},
           {Name::vertices_complete, Name::cells_nondegenerate, Name::facets_paired, Name::facets_opposite}),
       checkerboard},
      {"subgroup forgotten", volume, breaks({Name::volume_exact}), subgroup_forgotten},
      {"subgroup too large", volume, breaks({Name::volume_exact}), subgroup_too_large},
      {"subgroup too small",
       "the volumes are a proper fraction of that of the space, so no number of sheets is constant",
       breaks({Name::volume_exact}, tiles), subgroup_too_small},
      {"sheet missing", "the same", breaks({Name::volume_exact}, tiles), sheet_missing},
      {"subgroup with an element outside the group", "a fraction of a primitive lattice vector is none",
       outside, subgroup_outside},
      {"subgroup of infinite index", "its translations do not span the space", outside,
       subgroup_of_infinite_index},
  };
}

}  // namespace flatdt::edits
