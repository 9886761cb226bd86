#include "crystal_group.hpp"

#include <algorithm>

#include "flatdt/ref/group_analysis.hpp"

namespace flatdt::edits {

using ref::Isometry;
using ref::Rational;
using ref::Vector;

CrystalGroup::CrystalGroup(const ref::Matrix& gram, const std::vector<Isometry>& generators)
    : generators_(generators), lattice_(gram.dimension()) {
  ref::Instance instance;
  instance.dimension = gram.dimension();
  instance.generators = generators;
  instance.generators_given = true;
  instance.gram = gram;
  const ref::GroupAnalysis analysis = ref::analyse(instance);
  cosets_ = analysis.cosets;
  lattice_ = analysis.lattice;
}

Vector CrystalGroup::reduced(Vector x) const {
  for (int j = 0; j < x.dimension(); ++j) {
    const Rational times(ref::floor(x[j] / lattice_(j, j)));
    if (!times.is_zero()) x = x - times * lattice_.column(j);
  }
  return x;
}

CrystalGroup::Canonical CrystalGroup::canonical(const Vector& x) const {
  Canonical best{reduced(x), Isometry::identity(x.dimension())};
  best.mover = Isometry::translate(best.point - x);
  for (std::size_t k = 1; k < cosets_.size(); ++k) {
    const Vector moved = cosets_[k] * x;
    const Vector candidate = reduced(moved);
    if (candidate < best.point) best = {candidate, Isometry::translate(candidate - moved) * cosets_[k]};
  }
  return best;
}

bool CrystalGroup::contains(const Isometry& g) const {
  return std::any_of(cosets_.begin(), cosets_.end(), [&](const Isometry& r) {
    return r.linear == g.linear && reduced(g.translation - r.translation).is_zero();
  });
}

std::size_t CrystalGroup::index_of(const CrystalGroup& subgroup) const {
  const Rational lattices = subgroup.lattice_.determinant() / lattice_.determinant();
  const Rational holonomies(static_cast<long>(cosets_.size()));
  const Rational index = lattices * holonomies / Rational(static_cast<long>(subgroup.cosets_.size()));
  return static_cast<std::size_t>(index.numerator().to_long());
}

std::vector<Isometry> CrystalGroup::right_cosets(const CrystalGroup& subgroup) const {
  std::vector<Isometry> found = {Isometry::identity(lattice_.dimension())};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Isometry& s : generators_) {
      const Isometry next = found[i] * s;
      const bool known = std::any_of(found.begin(), found.end(), [&](const Isometry& f) {
        return subgroup.contains(next * f.inverse());
      });
      if (!known) found.push_back(next);
    }
  return found;
}

bool CrystalGroup::same_as(const CrystalGroup& other) const {
  const auto within = [](const CrystalGroup& a, const CrystalGroup& b) {
    return std::all_of(a.generators_.begin(), a.generators_.end(),
                       [&](const Isometry& g) { return b.contains(g); });
  };
  return within(*this, other) && within(other, *this);
}

}  // namespace flatdt::edits
