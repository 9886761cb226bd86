#include "lifted_star.hpp"

#include <algorithm>
#include <map>

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
  std::vector<Cell> kept;
  std::map<std::array<OrbitPoint, D>, std::pair<int, std::array<Lift, D>>> facets;  // with how many cells go
  for (const Cell& cell : cells_) {
    if (!predicates_->conflict_sos(cell.lifts, p)) {
      kept.push_back(cell);
      continue;
    }
    for (std::size_t j = 0; j <= D; ++j) {
      if (cell.lifts[j].point == q_.point) continue;
      std::array<Lift, D> facet;
      for (std::size_t k = 0, i = 0; k <= D; ++k)
        if (k != j) facet[i++] = cell.lifts[k];
      std::array<OrbitPoint, D> key;
      for (std::size_t i = 0; i < D; ++i) key[i] = facet[i].point;
      std::sort(key.begin(), key.end());
      auto& [count, lifts] = facets[key];
      ++count;
      lifts = facet;
    }
  }
  if (kept.size() == cells_.size()) return false;
  cells_ = std::move(kept);
  for (const auto& [key, entry] : facets) {
    if (entry.first != 1) continue;
    std::array<Lift, D + 1> lifts;
    std::copy(entry.second.begin(), entry.second.end(), lifts.begin());
    lifts[D] = p;
    add(lifts);
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
