#include "elements.hpp"

#include <limits>

#include "flatdt/checker/errors.hpp"

namespace flatdt::checker {

bool ElementTable::Less::operator()(const Element& a, const Element& b) const {
  if (a.rotation != b.rotation) return a.rotation < b.rotation;
  for (std::size_t i = 0; i < a.shift.size(); ++i) {
    const int order = cmp(a.shift[i], b.shift[i]);
    if (order != 0) return order < 0;
  }
  return false;
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
