/// Moves of the group and of the way it is given.
#include "moves.hpp"

namespace flatdt::fuzz {
namespace {

using ref::Isometry;
using ref::Matrix;
using ref::Rational;
using ref::Vector;

/// Another named group. Points keep their coordinates as far as the dimension allows; the metric starts anew.
void rename(Specimen& specimen, int group) {
  specimen.group = group;
  specimen.claim = 0;
  specimen.change.reset();
  specimen.gram.reset();
  specimen.generators.clear();
  specimen.has_subgroup = false;
  specimen.subgroup.clear();
  specimen.elements.clear();
  specimen.cells.clear();
  for (Vector& x : specimen.points) x = in_dimension(x, specimen.dimension());
}

/// The same group in the coordinates of the file, given by its generators alone.
bool list_generators(Specimen& specimen) {
  if (specimen.named() == nullptr) return false;
  const ref::Instance instance = instance_of(specimen);
  const ref::Triangulation triangulation = triangulation_of(specimen);
  if (instance.generators.size() > kMaxGenerators) return false;
  specimen.group = listed_group(instance.dimension);
  specimen.name_only = false;
  specimen.words.clear();
  specimen.change.reset();
  specimen.generators = instance.generators;
  specimen.gram = instance.gram;
  specimen.points = instance.points;
  return set_triangulation(specimen, triangulation);
}

/// A product of elementary matrices, now and then with a stretch, and an origin.
Isometry random_change(int d, Random& random) {
  Isometry change = Isometry::identity(d);
  for (int step = random.below(4); step > 0; --step) {
    const int i = random.below(d);
    const int j = random.below(d);
    Matrix elementary = Matrix::identity(d);
    elementary(i, j) =
        i == j ? Rational(random.one_in(2) ? -1 : 1 + random.below(3)) : Rational(random.below(5) - 2);
    change.linear = elementary * change.linear;
  }
  if (random.one_in(2))
    for (int i = 0; i < d; ++i) change.translation[i] = simple_rational(random);
  return change;
}

/// Changes the generators of a listed group.
bool move_generators(Specimen& specimen, Random& random) {
  std::vector<Isometry>& generators = specimen.generators;
  const int d = specimen.dimension();
  Isometry& g = generators[random.index(generators.size())];
  const Isometry h = generators[random.index(generators.size())];
  switch (random.below(9)) {
    case 0:
      g = g * h;
      return true;
    case 1:
      if (g.linear.determinant().is_zero()) return false;
      g = g.inverse();
      return true;
    case 2:  // a conjugate: another element of the same kind
      if (h.linear.determinant().is_zero()) return false;
      g = h * g * h.inverse();
      return true;
    case 3:
      g.translation[random.below(d)] = simple_rational(random);
      return true;
    case 4: {
      const Rational entry = random.one_in(3) ? simple_rational(random) : Rational(random.below(3) - 1);
      const int column = random.below(d);
      g.linear(random.below(d), column) = entry;
      return true;
    }
    case 5:
      g.translation[random.below(d)] += tiny_rational(random);
      return true;
    case 6: {  // an element of a named group
      const auto& groups = named_groups();
      const NamedGroup& group = groups[random.index(groups.size())];
      if (group.entry->dimension != d || generators.size() >= kMaxGenerators) return false;
      generators.push_back(group.cosets[random.index(group.cosets.size())]);
      return true;
    }
    case 7:
      if (generators.size() < 2) return false;
      generators.erase(generators.begin() + static_cast<std::ptrdiff_t>(random.index(generators.size())));
      return true;
    default: {  // a unit translation
      if (generators.size() >= kMaxGenerators) return false;
      Vector t(d);
      t[random.below(d)] = random.one_in(4) ? simple_rational(random) : Rational(1);
      generators.push_back(Isometry::translate(t));
      return true;
    }
  }
}

}  // namespace

bool move_group(Specimen& specimen, Random& random) {
  if (specimen.named() == nullptr && !random.one_in(6)) return move_generators(specimen, random);
  const auto groups = static_cast<int>(named_groups().size());
  switch (random.below(7)) {
    case 0:
      rename(specimen, random.below(groups));
      return true;
    case 1:
      specimen.name_only = !specimen.name_only;
      return true;
    case 2:
      specimen.claim = random.one_in(3) ? 1 + random.below(groups)
                                        : (specimen.named() != nullptr ? specimen.group + 1 : 0);
      return specimen.claim == 0 ||
             named_groups()[static_cast<std::size_t>(specimen.claim) - 1].entry->dimension ==
                 specimen.dimension();
    case 3:
      if (specimen.words.size() >= kMaxWords) {
        specimen.words.clear();
      } else {
        specimen.words.push_back(static_cast<std::uint8_t>(random.below(256)));
      }
      return true;
    case 4:
      return list_generators(specimen);
    default:
      specimen.name_only = false;
      if (specimen.named() == nullptr) return false;
      specimen.change = random_change(specimen.dimension(), random);
      if (specimen.change->linear.determinant().is_zero()) return false;
      return true;
  }
}

}  // namespace flatdt::fuzz
