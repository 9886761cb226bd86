#include "elements.hpp"

#include <limits>
#include <optional>

#include "flatdt/checker/errors.hpp"

namespace flatdt::checker {
namespace {

/// Six bits for the rotation (a point group has at most 48) and 19 for each component of the shift, if it is
/// small.
std::optional<std::uint64_t> packed(const Element& element) {
  constexpr long kLimit = 1L << 18;
  std::uint64_t key = element.rotation;
  for (const Integer& x : element.shift) {
    if (!x.fits_slong_p()) return std::nullopt;
    const long value = x.get_si();
    if (value < -kLimit || value >= kLimit) return std::nullopt;
    key = (key << 19) | static_cast<std::uint64_t>(value + kLimit);
  }
  return key;
}

}  // namespace

bool ElementTable::Less::operator()(const Element& a, const Element& b) const {
  if (a.rotation != b.rotation) return a.rotation < b.rotation;
  for (std::size_t i = 0; i < a.shift.size(); ++i) {
    const int order = cmp(a.shift[i], b.shift[i]);
    if (order != 0) return order < 0;
  }
  return false;
}

ElementTable::ElementTable(const Group& group, std::size_t most_limbs)
    : group_(group), limbs_left_(most_limbs) {
  intern(Element{});
}

ElementId ElementTable::intern(const Element& element) {
  if (elements_.size() == std::numeric_limits<std::uint32_t>::max()) {
    throw ResourceLimit("more than 2^32 - 1 group elements");
  }
  const auto next = make_id<ElementId>(elements_.size());
  const std::optional<std::uint64_t> key = packed(element);
  const ElementId id = key ? make_id<ElementId>(small_.insert(*key, static_cast<std::uint32_t>(next)))
                           : large_.try_emplace(element, next).first->second;
  if (id != next) return id;
  if (!key) {
    std::size_t limbs = 0;
    for (const Integer& x : element.shift) limbs += mpz_size(x.get_mpz_t());
    if (limbs > limbs_left_) throw ResourceLimit("group elements with too many digits together");
    limbs_left_ -= limbs;
  }
  elements_.push_back(element);
  return id;
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
  if (const std::uint32_t known = quotients_.find(key); known != IdMap::kAbsent) {
    return make_id<ElementId>(known);
  }
  const ElementId result = intern(group_.multiply(group_.invert((*this)[a]), (*this)[b]));
  quotients_.insert(key, static_cast<std::uint32_t>(result));
  return result;
}

}  // namespace flatdt::checker
