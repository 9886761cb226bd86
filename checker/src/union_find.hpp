// Disjoint sets with the number of sets.
#pragma once

#include <boost/pending/disjoint_sets.hpp>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace flatdt::checker {

class UnionFind {
 public:
  explicit UnionFind(std::size_t size)
      : parent_(size), rank_(size), sets_(rank_.data(), parent_.data()), count_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  UnionFind(const UnionFind&) = delete;
  UnionFind& operator=(const UnionFind&) = delete;

  /// Joins the sets of a and b; whether they were different.
  bool join(std::size_t a, std::size_t b) {
    const std::uint32_t root_a = sets_.find_set(static_cast<std::uint32_t>(a));
    const std::uint32_t root_b = sets_.find_set(static_cast<std::uint32_t>(b));
    if (root_a == root_b) return false;
    sets_.link(root_a, root_b);
    --count_;
    return true;
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> rank_;
  boost::disjoint_sets<std::uint32_t*, std::uint32_t*> sets_;
  std::size_t count_;
};

}  // namespace flatdt::checker
