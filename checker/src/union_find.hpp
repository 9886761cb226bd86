// Disjoint sets with the number of sets, by rank and path halving.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace flatdt::checker {

class UnionFind {
 public:
  explicit UnionFind(std::size_t size) { reset(size); }

  /// `size` sets of one.
  void reset(std::size_t size) {
    parent_.resize(size);
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    rank_.assign(size, 0);
    count_ = size;
  }

  /// The representative of the set of a.
  std::uint32_t find(std::size_t a) {
    auto x = static_cast<std::uint32_t>(a);
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }

  /// Joins the sets of a and b; whether they were different.
  bool join(std::size_t a, std::size_t b) {
    std::uint32_t low = find(a);
    std::uint32_t high = find(b);
    if (low == high) return false;
    if (rank_[high] < rank_[low]) std::swap(low, high);
    if (rank_[high] == rank_[low]) ++rank_[high];
    parent_[low] = high;
    --count_;
    return true;
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> rank_;  // at most 32
  std::size_t count_ = 0;
};

}  // namespace flatdt::checker
