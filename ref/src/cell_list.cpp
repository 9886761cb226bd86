#include "flatdt/ref/cell_list.hpp"

namespace flatdt::ref {
namespace {

/// Brings the records of a part into the order of their keys, below `keys`, in place. `begin` becomes, for
/// each key, where its records begin, and where the last ones end. Each exchange brings one record to its
/// place for good: O(n + keys).
template <class Record, class KeyOf>
void sort_by_counting(Record* first, Record* last, std::size_t keys, const KeyOf& key_of,
                      std::vector<std::uint32_t>& begin, std::vector<std::uint32_t>& next) {
  begin.assign(keys + 1, 0);
  for (const Record* r = first; r != last; ++r) ++begin[key_of(*r) + 1];
  for (std::size_t key = 0; key < keys; ++key) begin[key + 1] += begin[key];
  next = begin;
  for (std::size_t key = 0; key < keys; ++key)
    while (next[key] < begin[key + 1]) {
      const std::size_t home = key_of(first[next[key]]);
      if (home == key)
        ++next[key];
      else
        std::swap(first[next[key]], first[next[home]++]);
    }
}

}  // namespace

template <int D>
void CellList<D>::sort() {
  // In ranges of sites whose cells fit in a cache of the second level (in space 900 kB), then by site: with
  // one pass over all sites each exchange missed all caches from some 10^5 sites on.
  constexpr unsigned kRangeBits = 12;
  constexpr std::size_t kRange = std::size_t{1} << kRangeBits;
  std::uint32_t last = 0;
  for (const Cell& cell : cells_) last = std::max(last, cell[0].site);
  std::vector<std::uint32_t> ranges, sites, next;
  sort_by_counting(
      cells_.begin(), cells_.end(), (last >> kRangeBits) + std::size_t{1},
      [](const Cell& cell) { return cell[0].site >> kRangeBits; }, ranges, next);
  for (std::size_t r = 0; r + 1 < ranges.size(); ++r) {
    const auto base = static_cast<std::uint32_t>(r << kRangeBits);
    Cell* const first = cells_.begin() + ranges[r];
    sort_by_counting(
        first, cells_.begin() + ranges[r + 1], std::min<std::size_t>(kRange, last - base + std::size_t{1}),
        [base](const Cell& cell) { return cell[0].site - base; }, sites, next);
    for (std::size_t site = 0; site + 1 < sites.size(); ++site)
      std::sort(first + sites[site], first + sites[site + 1],
                [this](const Cell& a, const Cell& b) { return is_less(a, b); });
  }
}

template class CellList<2>;
template class CellList<3>;

}  // namespace flatdt::ref
