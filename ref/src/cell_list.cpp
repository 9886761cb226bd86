#include "flatdt/ref/cell_list.hpp"

namespace flatdt::ref {

template <int D>
void CellList<D>::sort() {
  std::uint32_t last = 0;
  for (const Cell& cell : cells_) last = std::max(last, cell[0].site);
  std::vector<std::uint32_t> begin(std::size_t{last} + 2);
  for (const Cell& cell : cells_) ++begin[cell[0].site + 1];
  for (std::size_t site = 0; site <= last; ++site) begin[site + 1] += begin[site];
  std::vector<std::uint32_t> next = begin;
  // Each exchange brings one cell to its site's part for good.
  for (std::size_t site = 0; site <= last; ++site)
    while (next[site] < begin[site + 1]) {
      const std::uint32_t home = cells_[next[site]][0].site;
      if (home == site)
        ++next[site];
      else
        std::swap(cells_[next[site]], cells_[next[home]++]);
    }
  for (std::size_t site = 0; site <= last; ++site)
    std::sort(cells_.begin() + begin[site], cells_.begin() + begin[site + 1],
              [this](const Cell& a, const Cell& b) { return is_less(a, b); });
}

template class CellList<2>;
template class CellList<3>;

}  // namespace flatdt::ref
