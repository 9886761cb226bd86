#include "oracle/group.hpp"

#include <algorithm>

namespace flatdt::oracle {
namespace {

const Seitz* with_linear_part(const std::vector<Seitz>& elements, const Matrix& linear) {
  const auto it =
      std::find_if(elements.begin(), elements.end(), [&](const Seitz& c) { return c.linear == linear; });
  return it == elements.end() ? nullptr : &*it;
}

}  // namespace

bool Group::contains(const Seitz& g) const {
  const Seitz* coset = with_linear_part(cosets, g.linear);
  return coset != nullptr && lattice.contains(minus(g.translation, coset->translation));
}

Rational Group::covolume() const {
  return lattice.covolume(dimension) / Rational(cosets.size());
}

bool Group::is_orientable() const {
  return std::all_of(cosets.begin(), cosets.end(),
                     [&](const Seitz& c) { return determinant(c.linear, dimension) > 0; });
}

std::pair<Vector, Seitz> Group::canonical(const Vector& x) const {
  std::optional<std::pair<Vector, Seitz>> best;
  for (const Seitz& c : cosets) {
    const Vector y = image(c, x);
    const Vector z = lattice.reduced(y);
    if (!best || z < best->first) best = {z, {c.linear, plus(c.translation, minus(z, y))}};
  }
  return *best;
}

std::optional<Group> generated_group(int dimension, const std::vector<Seitz>& generators,
                                     const Matrix& metric) {
  for (const Seitz& g : generators)
    if (product(transposed(g.linear), product(metric, g.linear)) != metric) return std::nullopt;
  const std::size_t bound = dimension == 2 ? 12 : 48;
  Group group{dimension, {translation_by({}, dimension)}, {}};
  for (std::size_t k = 0; k < group.cosets.size(); ++k) {
    for (const Seitz& g : generators) {
      const Seitz h = composed(group.cosets[k], g);
      if (const Seitz* known = with_linear_part(group.cosets, h.linear)) {
        const Vector v = minus(h.translation, known->translation);
        if (!group.lattice.contains(v)) group.lattice.insert(v);
      } else if (group.cosets.size() == bound) {
        return std::nullopt;
      } else {
        group.cosets.push_back(h);
      }
    }
  }
  if (group.lattice.rank() < dimension) return std::nullopt;
  return group;
}

}  // namespace flatdt::oracle
