/// The neighbours of a vertex in a quotient complex, by a walk over the lifts of cells around it.
#include <algorithm>
#include <bit>

#include "flatdt/ref/quotient_complex.hpp"

namespace flatdt::ref {
namespace {

/// A lift of a cell that has the point: `lift` times its base lift.
struct CellAround {
  CellId cell;
  Element lift;
  std::uint32_t centre;  // which of its vertices the point is
};

/// Lifts of cells in the order in which they came, and an open hash table of them.
class CellsAround {
 public:
  CellsAround() : slots_(128, kFree) { cells_.reserve(64); }

  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] CellAround& operator[](std::size_t i) { return cells_[i]; }
  /// Whether it was new; it is the last one then.
  bool insert(CellId cell, const Element& lift) {
    if (2 * cells_.size() >= slots_.size()) grow();
    std::uint32_t& slot = slot_of(cell, lift);
    if (slot != kFree) return false;
    slot = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back({cell, lift, 0});
    return true;
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffU;

  /// Where it stands, or will stand. Bounded: the table is at most half full.
  std::uint32_t& slot_of(CellId cell, const Element& lift) {
    const std::uint64_t hash = (index_of(cell) * 0xff51afd7ed558ccdU ^ lift.packed()) * 0x9e3779b97f4a7c15U;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = hash >> 32U & mask;; i = (i + 1) & mask)
      if (slots_[i] == kFree || (cells_[slots_[i]].cell == cell && cells_[slots_[i]].lift == lift))
        return slots_[i];
  }
  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (std::uint32_t i = 0; i < cells_.size(); ++i) slot_of(cells_[i].cell, cells_[i].lift) = i;
  }

  std::vector<CellAround> cells_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace

template <int D>
std::vector<OrbitPoint> QuotientComplex<D>::neighbours(VertexId v) const {
  const auto point_of = [this](CellId c, const Element& lift, std::uint32_t k) {
    const OrbitPoint base = point(cell(c).vertex[k]);
    return OrbitPoint{base.site, table_->multiply(table_->multiply(lift, offset(c, k)), base.g)};
  };
  std::vector<OrbitPoint> result;
  result.reserve(64);
  CellsAround around;
  const CellId first = vertex(v).cell;
  std::uint32_t centre = 0;
  while (cell(first).vertex[centre] != v) ++centre;
  around.insert(first, table_->inverse(offset(first, centre)));
  around[0].centre = centre;
  for (std::uint32_t k = 0; k <= D; ++k)
    if (k != centre) result.push_back(point_of(first, around[0].lift, k));
  for (std::size_t i = 0; i < around.size(); ++i) {
    const CellAround here = around[i];
    for (std::uint32_t k = 0; k <= D; ++k) {
      if (k == here.centre) continue;
      const CellId next = cell(here.cell).neighbour[k];
      const Element lift = table_->multiply(here.lift, gluing(here.cell, k));
      if (!around.insert(next, lift)) continue;
      centre = 0;
      while (centre <= D &&
             !(cell(next).vertex[centre] == v && table_->multiply(lift, offset(next, centre)).is_identity()))
        ++centre;
      ensure(centre <= D, "a facet through a vertex is in two cells with this vertex");
      around[around.size() - 1].centre = centre;
      // Its other vertices are in the cell before.
      result.push_back(point_of(next, lift, mirror_facet(here.cell, k)));
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

template std::vector<OrbitPoint> QuotientComplex<2>::neighbours(VertexId) const;
template std::vector<OrbitPoint> QuotientComplex<3>::neighbours(VertexId) const;

}  // namespace flatdt::ref
