#include "elements.hpp"

#include <limits>

#include "flatdt/checker/errors.hpp"

namespace flatdt::checker {

std::size_t ElementTable::Hash::operator()(const Element& element) const {
  std::uint64_t hash = element.rotation;
  for (const Integer& x : element.shift) {
    hash = MixHash{}(hash + (x < 0 ? 1 : 2));
    for (std::size_t i = 0; i < mpz_size(x.get_mpz_t()); ++i) {
      hash = MixHash{}(hash ^ mpz_getlimbn(x.get_mpz_t(), static_cast<mp_size_t>(i)));
    }
  }
  return hash;
}

ElementTable::ElementTable(const Group& group) : group_(group) {
  intern(Element{});
}

ElementId ElementTable::intern(const Element& element) {
  const auto [position, inserted] = ids_.try_emplace(element, make_id<ElementId>(elements_.size()));
  if (inserted && elements_.size() == std::numeric_limits<std::uint32_t>::max()) {
    throw ResourceLimit("more than 2^32 - 1 group elements");
  }
  if (inserted) elements_.push_back(element);
  return position->second;
}

ElementId ElementTable::product(ElementId a, ElementId b) {
  return intern(group_.multiply((*this)[a], (*this)[b]));
}

ElementId ElementTable::inverse(ElementId a) {
  return left_quotient(a, kIdentity);
}

ElementId ElementTable::left_quotient(ElementId a, ElementId b) {
  if (a == b) return kIdentity;
  if (a == kIdentity) return b;
  const std::uint64_t key = pair_key(a, b);
  if (const auto known = quotients_.find(key); known != quotients_.end()) return known->second;
  const ElementId result = intern(group_.multiply(group_.invert((*this)[a]), (*this)[b]));
  quotients_.emplace(key, result);
  return result;
}

}  // namespace flatdt::checker
