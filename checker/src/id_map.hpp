// A map from 64-bit keys to 32-bit numbers that no choice of keys makes slow.
//
// The keys are the file's choice, so a fixed hash alone could be made to collide, and a random one would not
// be reproducible. Here a key has kProbes places in a flat table; keys that find all of theirs taken go to an
// ordered map.
// Invariant: a key is in the overflow only if its kProbes places are taken by others; places are never freed
// between rehashes, and a rehash inserts everything anew. So a free place on the way proves a key absent.
// Cost: expected constant; at worst O(log^2 n) for each insertion, the rehashes included, and O(log n) for
// each search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace flatdt::checker {

/// Two 32-bit ids as one key.
template <class A, class B>
[[nodiscard]] constexpr std::uint64_t pair_key(A a, B b) {
  return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint64_t>(b);
}

class IdMap {
 public:
  static constexpr std::uint32_t kAbsent = 0xFFFFFFFF;

  /// The value of `key`, which becomes `value` if it had none.   Requires: value is not kAbsent.
  std::uint32_t insert(std::uint64_t key, std::uint32_t value) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    std::size_t place = mix(key) & mask();
    for (unsigned probe = 0; probe < kProbes; ++probe, place = (place + 1) & mask()) {
      Slot& slot = slots_[place];
      if (slot.value == kAbsent) {
        slot = {key, value};
        ++size_;
        return value;
      }
      if (slot.key == key) return slot.value;
    }
    return overflow_.try_emplace(key, value).first->second;
  }

  /// The value of `key`, or kAbsent.
  [[nodiscard]] std::uint32_t find(std::uint64_t key) const {
    if (slots_.empty()) return kAbsent;
    std::size_t place = mix(key) & mask();
    for (unsigned probe = 0; probe < kProbes; ++probe, place = (place + 1) & mask()) {
      const Slot& slot = slots_[place];
      if (slot.value == kAbsent || slot.key == key) return slot.value;
    }
    const auto known = overflow_.find(key);
    return known == overflow_.end() ? kAbsent : known->second;
  }

  /// How many keys are in the ordered map.
  [[nodiscard]] std::size_t overflow() const { return overflow_.size(); }

  /// Forgets all keys.
  void clear() {
    if (size_ == 0) return;  // then the overflow is empty, too
    slots_.clear();
    overflow_.clear();
    size_ = 0;
  }

 private:
  static constexpr unsigned kProbes = 8;
  static constexpr std::size_t kLeast = 16;

  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t value = kAbsent;
  };

  /// Consecutive ids must not fall into consecutive places.   Source: SplitMix of [SteeleLeaFlood14].
  [[nodiscard]] static std::size_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  }
  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }

  void grow() {
    const std::vector<Slot> old_slots = std::move(slots_);
    const std::map<std::uint64_t, std::uint32_t> old_overflow = std::move(overflow_);
    slots_.assign(std::max(kLeast, 2 * old_slots.size()), Slot{});
    overflow_.clear();
    size_ = 0;
    for (const Slot& slot : old_slots) {
      if (slot.value != kAbsent) insert(slot.key, slot.value);
    }
    for (const auto& [key, value] : old_overflow) insert(key, value);
  }

  std::vector<Slot> slots_;  // a power of two of them, or none
  std::map<std::uint64_t, std::uint32_t> overflow_;
  std::size_t size_ = 0;  // of the keys in slots_
};

}  // namespace flatdt::checker
