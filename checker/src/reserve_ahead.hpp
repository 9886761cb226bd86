// Memory for lists whose lengths the file claims.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flatdt::checker {

/// Makes room for the next entry of a list of `claimed` entries: eight times as much where the list is full,
/// twice as much where it is long, and never more than claimed.
/// Memory is as read, not as claimed: what is not written yet is address space only. Law: of a list that is
/// not long at most a seventh of the entries are ever moved to another place, which for GMP's numbers is a
/// copy (doubling: up to all of them).
template <class T>
void reserve_ahead(std::vector<T>& list, std::uint64_t claimed) {
  constexpr std::uint64_t kFew = 1 << 14;
  constexpr std::uint64_t kLong = 1 << 22;
  if (list.size() < list.capacity()) return;
  const std::uint64_t factor = list.capacity() < kLong ? 8 : 2;
  list.reserve(std::min(claimed, std::max(kFew, factor * list.capacity())));
}

}  // namespace flatdt::checker
