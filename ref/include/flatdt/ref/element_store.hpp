/// Group elements in few bits, as the cells of a complex and of an answer keep them.
/// An element that moves by little along each axis is its own code; the others are numbered as they come. The
/// edges of a Delaunay triangulation of complete orbits lie in 2V, V the Voronoi cell of the reduced lattice,
/// so that on E^d/G nearly all are of the first kind whatever the metric; the others are those of long
/// covers. Law: elements are equal iff their codes are; the codes of the first kind are in the order of the
/// elements.
#pragma once

#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "flatdt/ref/group_table.hpp"

namespace flatdt::ref {

/// Codes of the first kind have kAxisBits for each axis, for moves from -2^(kAxisBits - 1) on, and below them
/// the coset; the highest bit of a code says that it is of the second.
template <class CodeType, unsigned kAxisBits, unsigned kCosetBits>
class ElementCodes {
 public:
  using Code = CodeType;
  static constexpr Code kNumbered = static_cast<Code>(Code{1} << (8 * sizeof(Code) - 1));
  /// The code of the identity.
  static constexpr Code kIdentity =
      static_cast<Code>(((1U << (2 * kAxisBits) | 1U << kAxisBits | 1U) << (kAxisBits - 1)) << kCosetBits);
  static_assert(3 * kAxisBits + kCosetBits < 8 * sizeof(Code) && std::is_unsigned_v<Code>);

  [[nodiscard]] Element operator[](Code code) const {
    if (code >= kNumbered) return numbered_[code - kNumbered];
    return Element{{axis(code, 2), axis(code, 1), axis(code, 0)},
                   static_cast<std::uint16_t>(code & ((1U << kCosetBits) - 1))};
  }
  /// Errors: LimitReached at the 2^15 + 1st (2^31 + 1st) element that is not its own code.
  [[nodiscard]] Code code(const Element& g) {
    const unsigned x = shifted(g.t[0]), y = shifted(g.t[1]), z = shifted(g.t[2]);
    if ((x | y | z) < kSteps && g.coset < 1U << kCosetBits) return own_code(x, y, z, g.coset);
    return number(g);
  }

 private:
  static constexpr unsigned kSteps = 1U << kAxisBits;
  static constexpr int kHalf = 1 << (kAxisBits - 1);

  static std::int16_t axis(Code code, unsigned place) {
    return static_cast<std::int16_t>(
        static_cast<int>(code >> (kCosetBits + place * kAxisBits) & (kSteps - 1)) - kHalf);
  }
  static unsigned shifted(std::int16_t t) { return static_cast<unsigned>(t + kHalf); }
  static constexpr Code own_code(unsigned x, unsigned y, unsigned z, unsigned coset) {
    return static_cast<Code>(((x << kAxisBits | y) << kAxisBits | z) << kCosetBits | coset);
  }
  Code number(const Element& g) {
    const auto [entry, is_new] =
        codes_.try_emplace(g.packed(), static_cast<Code>(kNumbered + numbered_.size()));
    if (is_new) {
      if (numbered_.size() == kNumbered) {
        codes_.erase(entry);
        throw LimitReached("the cells need more than " + std::to_string(kNumbered) +
                           " group elements that move by " + std::to_string(kHalf) +
                           " lattice vectors or more");
      }
      numbered_.push_back(g);
    }
    return entry->second;
  }

  std::vector<Element> numbered_;
  std::unordered_map<std::uint64_t, Code> codes_;
};

/// 16 bits, moves by -8 to 7: in the cells of a complex.
using ElementStore = ElementCodes<std::uint16_t, 4, 3>;
/// 32 bits, moves by -256 to 255: in the cells of an answer.
using WideElementStore = ElementCodes<std::uint32_t, 9, 4>;

}  // namespace flatdt::ref
