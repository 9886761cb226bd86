// Elements of G interned as small ids, so that the work per cell is on ids and big integers appear once per
// element.
//
// Invariants: equal elements have equal ids; the identity is ElementId{0}.
// Cost: that of an IdMap for a quotient seen before; otherwise one multiplication in the group, and O(log n)
// comparisons if the result has large shifts, n the number of elements.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "flatdt/checker/ids.hpp"
#include "group.hpp"
#include "id_map.hpp"

namespace flatdt::checker {

inline constexpr ElementId kIdentity{0};

class ElementTable {
 public:
  /// Errors of all that intern: ResourceLimit when the shifts that are not small have more than `most_limbs`
  /// of 64 bits together; then the table is of no more use. A few thousand elements with shifts of thousands
  /// of digits have millions of quotients.
  explicit ElementTable(const Group& group, std::size_t most_limbs = kMostLimbs);
  static constexpr std::size_t kMostLimbs = std::size_t{1} << 26;  // 512 MB, and as much in the map

  ElementId intern(const Element& element);
  [[nodiscard]] const Element& operator[](ElementId id) const { return elements_[index(id)]; }
  [[nodiscard]] std::size_t size() const { return elements_.size(); }

  /// a b.
  ElementId product(ElementId a, ElementId b);
  /// a^-1.
  ElementId inverse(ElementId a);
  /// a^-1 b, remembered for each pair.
  ElementId left_quotient(ElementId a, ElementId b);

  [[nodiscard]] const Group& group() const { return group_; }

 private:
  /// A total order without meaning, for the elements with large shifts.
  struct Less {
    [[nodiscard]] bool operator()(const Element& a, const Element& b) const;
  };

  const Group& group_;
  std::vector<Element> elements_;
  IdMap small_;  // by the packed rotation and shift
  std::map<Element, ElementId, Less> large_;
  std::size_t limbs_left_;  // of the shifts in it
  IdMap quotients_;
};

}  // namespace flatdt::checker
