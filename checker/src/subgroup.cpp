#include "subgroup.hpp"

#include <string>
#include <utility>

#include "flatdt/checker/errors.hpp"
#include "linear.hpp"

namespace flatdt::checker {

std::variant<Subgroup, Witness> Subgroup::make(const Group& group, const std::vector<Seitz>* generators) {
  const int d = group.dimension;
  std::vector<Seitz> inner;  // in lattice coordinates of G
  if (generators == nullptr) {
    for (std::size_t r = 0; r < group.order(); ++r) {
      inner.push_back(group.lattice_seitz({static_cast<std::uint8_t>(r), {}}));
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
      Element shift;
      shift.shift[i] = 1;
      inner.push_back(group.lattice_seitz(shift));
    }
  } else {
    for (std::size_t i = 0; i < generators->size(); ++i) {
      const std::optional<Element> element = group.locate((*generators)[i]);
      if (!element) {
        return Witness{{"reason", "subgroup-generator-not-in-group"},
                       {"generator", std::to_string(i)},
                       {"element", to_string(d, (*generators)[i])}};
      }
      inner.push_back(group.lattice_seitz(*element));
    }
  }
  const std::variant<Crystal, Witness> closed = close_group(d, inner, nullptr);
  const Crystal* crystal = std::get_if<Crystal>(&closed);
  if (crystal == nullptr)
    throw InternalError("a subgroup of a crystallographic group is not crystallographic");
  if (crystal->lattice.rank() < d) {
    return Witness{{"reason", "infinite-index"},
                   {"rank-of-lattice", std::to_string(crystal->lattice.rank())}};
  }
  return Subgroup(group, *crystal);
}

Subgroup::Subgroup(const Group& group, const Crystal& crystal)
    : lattice_(crystal.lattice), own_(make_group(crystal)) {
  Group inner = group;  // G with its own lattice coordinates as outer coordinates
  inner.basis = inner.basis_inverse = identity<Rational>(group.dimension);
  for (std::size_t r = 0; r < group.order(); ++r) {
    inner.representative[r] = group.lattice_seitz({static_cast<std::uint8_t>(r), {}});
  }
  for (const Seitz& h : crystal.representatives) {
    const std::optional<Element> element = inner.locate(h);
    if (!element) throw InternalError("a product of elements left the group");
    representatives_.push_back(*element);
  }
  volume_ = abs(determinant(group.dimension, own_.basis)) / static_cast<unsigned long>(own_.order());
  const Rational index = volume_ * static_cast<unsigned long>(group.order());
  if (index.get_den() != 1) throw InternalError("the index of the subgroup is not an integer");
  index_ = index.get_num();
}

CosetPosition Subgroup::locate(ElementTable& table, ElementId g) const {
  const Group& group = table.group();
  const Element& element = table[g];
  const Element* best = nullptr;
  std::size_t least = group.order();
  for (const Element& h : representatives_) {
    const std::size_t rotation = group.product[h.rotation][element.rotation];
    if (rotation >= least) continue;
    least = rotation;
    best = &h;
  }
  Element canonical = group.multiply(*best, element);
  lattice_.reduce(canonical.shift);
  const Element transport = group.multiply(element, group.invert(canonical));
  return {table.intern(canonical), table.intern(transport)};
}

}  // namespace flatdt::checker
