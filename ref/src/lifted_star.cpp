#include "lifted_star.hpp"

#include <algorithm>

namespace flatdt::ref {

template <int D>
void LiftedStar<D>::add(const std::array<Lift, D + 1>& lifts) {
  Cell cell{lifts};
  const Sign sign = predicates_->orientation(cell.lifts);
  ensure(sign != Sign::zero, "a cell of the star is not flat");
  if (sign == Sign::negative) std::swap(cell.lifts[0], cell.lifts[1]);
  cells_.push_back(cell);
}

template <int D>
bool LiftedStar<D>::insert(const Lift& p) {
  // A facet through q of the cells that go. With their points sorted two equal ones come together.
  struct Facet {
    std::array<OrbitPoint, D> key;
    std::size_t cell;
    std::size_t opposite;
  };
  std::vector<Facet> facets;
  std::vector<Cell> kept;
  std::vector<Cell> gone;
  for (const Cell& cell : cells_) {
    if (!predicates_->conflict_sos(cell.lifts, p)) {
      kept.push_back(cell);
      continue;
    }
    for (std::size_t j = 0; j <= D; ++j) {
      if (cell.lifts[j].point == q_.point) continue;
      Facet facet{{}, gone.size(), j};
      for (std::size_t k = 0, i = 0; k <= D; ++k)
        if (k != j) facet.key[i++] = cell.lifts[k].point;
      std::sort(facet.key.begin(), facet.key.end());
      facets.push_back(facet);
    }
    gone.push_back(cell);
  }
  if (gone.empty()) return false;
  cells_ = std::move(kept);
  std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) { return a.key < b.key; });
  for (std::size_t i = 0; i < facets.size();) {
    std::size_t end = i + 1;
    while (end < facets.size() && facets[end].key == facets[i].key) ++end;
    if (end == i + 1) {
      std::array<Lift, D + 1> lifts = gone[facets[i].cell].lifts;
      lifts[facets[i].opposite] = p;
      add(lifts);
    }
    i = end;
  }
  return true;
}

template <int D>
std::vector<CellPoints<D>> LiftedStar<D>::points() const {
  std::vector<CellPoints<D>> result;
  result.reserve(cells_.size());
  for (const Cell& cell : cells_) {
    CellPoints<D> points;
    for (std::size_t k = 0; k <= D; ++k) points[k] = cell.lifts[k].point;
    result.push_back(points);
  }
  return result;
}

template class LiftedStar<2>;
template class LiftedStar<3>;

}  // namespace flatdt::ref
