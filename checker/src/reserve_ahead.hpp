// Memory for lists whose lengths the file claims.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flatdt::checker {

/// Makes room for the next entry of a list of `claimed` entries: eight times as much where the list is full,
/// and never more than claimed.
/// Memory is as read, not as claimed: what is not written yet is address space only. Law: at most a seventh
/// of the entries are ever moved to another place, which for GMP's numbers is a copy (doubling: up to all of
/// them).
template <class T>
void reserve_ahead(std::vector<T>& list, std::uint64_t claimed) {
  constexpr std::uint64_t kFew = 1 << 14;
  constexpr std::uint64_t kFactor = 8;
  if (list.size() < list.capacity()) return;
  list.reserve(std::min(claimed, std::max(kFew, kFactor * list.capacity())));
}

}  // namespace flatdt::checker
