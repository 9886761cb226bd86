/// Group elements in 16 bits, as the cells of a complex keep them.
/// An element that moves by -8 to 7 lattice vectors along each axis is its own code: 4 bits for each and 3
/// for the coset. The edges of a Delaunay triangulation of complete orbits lie in 2V, V the Voronoi cell of
/// the reduced lattice, so that on E^d/G nearly all are of this kind whatever the metric; the others, as in
/// long covers, are numbered as they come.
#pragma once

#include <unordered_map>
#include <vector>

#include "flatdt/ref/group_table.hpp"

namespace flatdt::ref {

class ElementStore {
 public:
  using Code = std::uint16_t;

  [[nodiscard]] Element operator[](Code code) const {
    if (code >= kNumbered) return numbered_[code - kNumbered];
    return Element{{axis(code, 0), axis(code, 4), axis(code, 8)}, static_cast<std::uint16_t>(code >> 12U)};
  }
  /// Errors: LimitReached at the 32,769th element that is not its own code.
  [[nodiscard]] Code code(const Element& g) {
    const unsigned x = shifted(g.t[0]), y = shifted(g.t[1]), z = shifted(g.t[2]);
    if ((x | y | z) < 16 && g.coset < 8)
      return static_cast<Code>(x | y << 4U | z << 8U | unsigned{g.coset} << 12U);
    return number(g);
  }

 private:
  static constexpr Code kNumbered = 0x8000;

  static std::int16_t axis(Code code, unsigned shift) {
    return static_cast<std::int16_t>(static_cast<int>(code >> shift & 15U) - 8);
  }
  static unsigned shifted(std::int16_t t) { return static_cast<unsigned>(t + 8); }
  Code number(const Element& g) {
    const auto [entry, is_new] =
        codes_.try_emplace(g.packed(), static_cast<Code>(kNumbered + numbered_.size()));
    if (is_new) {
      if (numbered_.size() == kNumbered) {
        codes_.erase(entry);
        throw LimitReached(
            "the cells need more than 32768 group elements that move by 8 lattice vectors or more");
      }
      numbered_.push_back(g);
    }
    return entry->second;
  }

  std::vector<Element> numbered_;
  std::unordered_map<std::uint64_t, Code> codes_;
};

}  // namespace flatdt::ref
