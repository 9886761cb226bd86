// Elements of G interned as small ids, so that the work per cell is on ids and big integers appear once per
// element.
//
// Invariants: equal elements have equal ids; the identity is ElementId{0}.
// Cost: expected constant time per quotient seen before; otherwise one multiplication in the group and O(log
// n) comparisons, n the number of elements.
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "flatdt/checker/ids.hpp"
#include "group.hpp"

namespace flatdt::checker {

inline constexpr ElementId kIdentity{0};

/// Mixes a 64-bit key: consecutive ids must not fall into consecutive buckets.   Source: SplitMix of
/// [SteeleLeaFlood14].
struct MixHash {
  [[nodiscard]] std::size_t operator()(std::uint64_t x) const {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  }
};

/// Two 32-bit ids as one key.
template <class A, class B>
[[nodiscard]] constexpr std::uint64_t pair_key(A a, B b) {
  return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint64_t>(b);
}

class ElementTable {
 public:
  explicit ElementTable(const Group& group);

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
  /// A total order without meaning. An ordered map, because the elements are the file's choice: a fixed hash
  /// of them can be made to collide (1.8 MB of colliding translations took 47 s), and a random one would not
  /// be reproducible.
  struct Less {
    [[nodiscard]] bool operator()(const Element& a, const Element& b) const;
  };

  const Group& group_;
  std::vector<Element> elements_;
  std::map<Element, ElementId, Less> ids_;
  std::unordered_map<std::uint64_t, ElementId, MixHash> quotients_;
};

}  // namespace flatdt::checker
