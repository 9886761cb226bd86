/// Cells as lists of points of GP, in 8 bytes for each point: the answer for a million points is 217 MB in
/// space, and is made in the memory of the complex that it comes from.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "flatdt/ref/element_store.hpp"
#include "flatdt/ref/exact_predicates.hpp"
#include "flatdt/ref/records.hpp"

namespace flatdt::ref {

/// The d+1 points of GP of one lift of a cell.
template <int D>
using CellPoints = std::array<OrbitPoint, D + 1>;

template <int D>
class CellList {
 public:
  /// A point of GP: its site, and its element as a code of the list.
  struct Corner {
    std::uint32_t site;
    std::uint32_t code;
    friend bool operator==(const Corner&, const Corner&) = default;
  };
  using Cell = std::array<Corner, D + 1>;

  CellList() = default;
  explicit CellList(const std::vector<CellPoints<D>>& cells) {
    cells_.reserve(cells.size());
    for (const CellPoints<D>& points : cells) cells_.push_back(packed(points, codes_));
  }
  /// Requires: the codes are those of the cells.
  CellList(Records<Cell> cells, WideElementStore codes)
      : cells_(std::move(cells)), codes_(std::move(codes)) {}

  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] bool empty() const { return cells_.empty(); }
  [[nodiscard]] CellPoints<D> operator[](std::size_t i) const { return unpacked(cells_[i]); }

  /// Goes through the cells as values.
  class Iterator {
   public:
    Iterator(const CellList& list, std::size_t i) : list_(&list), i_(i) {}
    CellPoints<D> operator*() const { return (*list_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.i_ == b.i_; }

   private:
    const CellList* list_;
    std::size_t i_;
  };
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size()}; }

  /// All cells at full length: 48 bytes for each in space.
  [[nodiscard]] std::vector<CellPoints<D>> listed() const {
    std::vector<CellPoints<D>> all;
    all.reserve(size());
    for (const CellPoints<D>& points : *this) all.push_back(points);
    return all;
  }
  /// The same points in the same order; codes may differ.
  friend bool operator==(const CellList& a, const CellList& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i]) return false;
    return true;
  }
  /// Requires: the list is sorted.
  [[nodiscard]] bool has(const CellPoints<D>& points) const {
    std::size_t low = 0, high = size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if ((*this)[middle] < points)
        low = middle + 1;
      else
        high = middle;
    }
    return low < size() && (*this)[low] == points;
  }

  /// For those who work in the list's own memory.
  [[nodiscard]] Records<Cell>& cells() { return cells_; }
  [[nodiscard]] const WideElementStore& codes() const { return codes_; }
  void set(std::size_t i, const CellPoints<D>& points) { cells_[i] = packed(points, codes_); }
  static Cell packed(const CellPoints<D>& points, WideElementStore& codes) {
    Cell cell;
    for (std::size_t k = 0; k <= D; ++k) cell[k] = {index_of(points[k].site), codes.code(points[k].g)};
    return cell;
  }
  /// The order of the points. That of codes is that of elements, but not for numbered ones.
  [[nodiscard]] bool is_less(const Cell& a, const Cell& b) const {
    for (std::size_t k = 0; k <= D; ++k) {
      if (a[k].site != b[k].site) return a[k].site < b[k].site;
      if (a[k].code == b[k].code) continue;
      if ((a[k].code | b[k].code) < WideElementStore::kNumbered) return a[k].code < b[k].code;
      return codes_[a[k].code] < codes_[b[k].code];
    }
    return false;
  }
  /// Sorts in place: by counting of the first site, then each site's few cells.
  void sort();

 private:
  [[nodiscard]] CellPoints<D> unpacked(const Cell& cell) const {
    CellPoints<D> points;
    for (std::size_t k = 0; k <= D; ++k) points[k] = {SiteId{cell[k].site}, codes_[cell[k].code]};
    return points;
  }

  Records<Cell> cells_;
  WideElementStore codes_;
};

extern template class CellList<2>;
extern template class CellList<3>;

}  // namespace flatdt::ref
