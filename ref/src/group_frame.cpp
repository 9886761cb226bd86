/// The frame: a reduced lattice basis, and the map from it to catalogue coordinates.
#include <algorithm>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"
#include "group_parts.hpp"

namespace flatdt::ref {
namespace {

/// The elements {R|t} of a group seen from coordinates x' with x = axes x' + origin.
std::vector<Isometry> transported(const std::vector<Isometry>& cosets, const Matrix& axes,
                                  const Vector& origin) {
  const Isometry map{axes, origin}, inverse = map.inverse();
  std::vector<Isometry> result;
  result.reserve(cosets.size());
  for (const Isometry& g : cosets) result.push_back(inverse * g * map);
  make_canonical(Matrix::identity(axes.dimension()), result);
  return result;
}

/// With the axes y = axes^-1 x and x_catalogue = y - o, {R|t} becomes {R|t - (I - R) o}: the origin solves
/// (I - R) o = t - t_catalogue modulo Z^d for every coset. Nothing if the linear parts differ or no origin
/// fits. The origin is in [0,1) in catalogue coordinates, which are determined up to translations of the
/// group.
std::optional<CatalogueMap> find_origin(const WorkingGroup& group, const AxesCandidate& candidate,
                                        const CatalogueEntry& entry) {
  const int d = entry.dimension;
  if (abs(candidate.axes.determinant()) != Rational(1)) return std::nullopt;
  const std::vector<Isometry> ours = transported(group.cosets, candidate.axes, Vector(d));
  const std::vector<Isometry> theirs = catalogue_cosets(entry, candidate.mirrored);
  std::vector<Matrix> differences;
  std::vector<Vector> shifts;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    if (ours[k].linear != theirs[k].linear) return std::nullopt;
    differences.push_back(Matrix::identity(d) - ours[k].linear);
    shifts.push_back(ours[k].translation - theirs[k].translation);
  }
  const auto origin = solve_congruences(differences, shifts);
  if (!origin) return std::nullopt;
  const Vector reduced = reduced_modulo(Matrix::identity(d), *origin);
  return CatalogueMap{candidate.axes, candidate.axes * reduced, candidate.mirrored};
}

/// x_instance = axes x_catalogue + origin. If the group is literally the entry's or its mirror image, the
/// identity: so naming a manifold and listing its generators give the same frame.
CatalogueMap catalogue_map(const CosetGroup& group, const WorkingGroup& working,
                           const CatalogueEntry& entry) {
  const int d = entry.dimension;
  for (const bool mirrored : {false, true})
    if (group.lattice.is_identity() && group.cosets == catalogue_cosets(entry, mirrored))
      return {Matrix::identity(d), Vector(d), mirrored && !entry.mirror_image_generators.empty()};
  for (const AxesCandidate& candidate : axes_candidates(working, entry, working.basis.determinant().sign()))
    if (const auto map = find_origin(working, candidate, entry))
      return {working.basis * map->axes, working.basis * map->origin, map->mirrored};
  throw InternalError(
      "every flat manifold group is conjugate to its catalogue entry by the axes of its type");
}

/// The proof of the frame: conjugating the catalogue's lattice and cosets gives exactly this group.
void verify(const CosetGroup& group, const CatalogueMap& map, const CatalogueEntry& entry) {
  HermiteBasis lattice(entry.dimension);
  for (int j = 0; j < entry.dimension; ++j) lattice.add(map.axes.column(j));
  for (int j = 0; j < entry.dimension; ++j)
    ensure(lattice.vectors()[static_cast<std::size_t>(j)] == group.lattice.column(j),
           "the catalogue axes generate the translation lattice");
  const Isometry to_instance{map.axes, map.origin}, from_instance = to_instance.inverse();
  std::vector<Isometry> conjugated;
  for (const Isometry& g : catalogue_cosets(entry, map.mirrored))
    conjugated.push_back(to_instance * g * from_instance);
  make_canonical(group.lattice, conjugated);
  ensure(conjugated == group.cosets, "the catalogue's cosets, conjugated, are those of the group");
}

int common_denominator(const std::vector<Isometry>& cosets) {
  Integer denominator = 1;
  for (const Isometry& g : cosets)
    for (int i = 0; i < g.dimension(); ++i) denominator = lcm(denominator, g.translation[i].denominator());
  ensure(denominator <= Integer(6),
         "the translations of the catalogue are multiples of 1/2, 1/3, 1/4 or 1/6");
  return static_cast<int>(denominator.to_long());
}

}  // namespace

std::vector<Isometry> catalogue_cosets(const CatalogueEntry& entry, bool mirrored) {
  std::vector<Isometry> cosets = entry.coset_representatives;
  if (mirrored && !entry.mirror_image_generators.empty())  // the image under z -> -z, with z turned round
    for (Isometry& g : cosets) g.translation = -g.translation;
  make_canonical(Matrix::identity(entry.dimension), cosets);
  return cosets;
}

Frame make_frame(const CosetGroup& group, const WorkingGroup& working, const CatalogueEntry& entry,
                 const Matrix& gram) {
  const CatalogueMap map = catalogue_map(group, working, entry);
  verify(group, map, entry);
  const ReducedBasis reduced = reduce_basis(map.axes.transpose() * gram * map.axes);
  Frame frame;
  frame.dimension = entry.dimension;
  frame.basis = map.axes * reduced.transform;
  frame.origin = map.origin;
  frame.gram = reduced.gram;
  frame.to_catalogue = reduced.transform;
  frame.entry = &entry;
  frame.mirrored = map.mirrored;
  frame.delta_squared = delta_squared(working);
  // In the order of the catalogue coordinates, so not through transported(), which sorts.
  const Matrix from_catalogue = reduced.transform.inverse();
  for (const Isometry& g : catalogue_cosets(entry, map.mirrored)) {
    const Vector t = from_catalogue * g.translation;
    frame.cosets.push_back({from_catalogue * g.linear * reduced.transform,
                            reduced_modulo(Matrix::identity(entry.dimension), t)});
  }
  frame.translation_denominator = common_denominator(frame.cosets);
  return frame;
}

}  // namespace flatdt::ref
