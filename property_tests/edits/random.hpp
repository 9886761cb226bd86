/// Random choices for edits, the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "../generators/split_mix.hpp"

namespace flatdt::edits {

class Random : public testing::SplitMix64 {
 public:
  /// The stream of a seed and a name.
  Random(std::uint64_t seed, std::string_view name) : SplitMix64(start(seed, name)) { (void)next(); }

  /// A number of [0, bound); the bias of the remainder is below 2^-40 for the bounds here. Requires: bound >
  /// 0.
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(next() % bound); }

  /// An integer of [least, most].
  int between(int least, int most) {
    return least + static_cast<int>(below(static_cast<std::size_t>(most - least) + 1));
  }

  template <class T>
  const T& choice(const std::vector<T>& items) {
    return items[below(items.size())];
  }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

  /// The numbers 0 .. count-1 in random order.
  std::vector<std::size_t> order(std::size_t count) {
    std::vector<std::size_t> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = i;
    shuffle(all);
    return all;
  }

 private:
  static std::uint64_t start(std::uint64_t seed, std::string_view name) {
    std::uint64_t state = seed * 0x9E3779B97F4A7C15U;
    for (const char c : name) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return state;
  }
};

}  // namespace flatdt::edits
