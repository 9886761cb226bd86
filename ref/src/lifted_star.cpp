#include "lifted_star.hpp"

#include <algorithm>

namespace flatdt::ref {

namespace {

constexpr Sign alternating(std::size_t k) {
  return k % 2 == 0 ? Sign::positive : Sign::negative;
}

std::uint64_t hash_of(const OrbitPoint& p) {
  const std::uint64_t x = (p.g.packed() ^ index_of(p.site)) * 0x9e3779b97f4a7c15U;
  return x ^ x >> 32U;
}

}  // namespace

template <int D>
void LiftedStar<D>::add(const std::array<Lift, D + 1>& lifts) {
  std::size_t centre = 0;
  while (lifts[centre].point != q_.point) ++centre;
  std::array<typename StarFilter<D>::Offset, D> others;
  for (std::size_t k = 0, i = 0; k <= D; ++k)
    if (k != centre) others[i++] = filter_.see(lifts[k].x);
  std::array<typename StarFilter<D>::Offset, D - 1> base;
  std::copy(others.begin(), others.end() - 1, base.begin());
  // The orientation with q in front, and with q where it is.
  const std::optional<Sign> quick = filter_.orientation(filter_.plane(base), others[D - 1]);
  const Sign fronted = quick ? *quick : predicates_->orientation(lifts) * alternating(centre);
  ensure(fronted != Sign::zero, "a cell of the star is not flat");
  Cell cell{lifts, filter_.sphere(others, fronted == Sign::negative)};
  if (fronted * alternating(centre) == Sign::negative) std::swap(cell.lifts[0], cell.lifts[1]);
  cells_.push_back(cell);
}

template <int D>
bool LiftedStar<D>::same_points(const Facet& a, const Facet& b) const {
  const auto &u = gone_[a.cell].lifts, &v = gone_[b.cell].lifts;
  for (std::size_t i = 0; i <= D; ++i) {
    if (i == a.opposite) continue;
    bool found = false;
    for (std::size_t j = 0; j <= D; ++j) found = found || (j != b.opposite && u[i].point == v[j].point);
    if (!found) return false;
  }
  return true;
}

/// Equal facets come together.
template <int D>
void LiftedStar<D>::collect_facets() {
  facets_.clear();
  for (std::uint32_t c = 0; c < gone_.size(); ++c) {
    std::array<std::uint64_t, D + 1> hashes;
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k <= D; ++k) sum += hashes[k] = hash_of(gone_[c].lifts[k].point);
    for (std::uint32_t k = 0; k <= D; ++k)
      if (gone_[c].lifts[k].point != q_.point) facets_.push_back({sum - hashes[k], c, k});
  }
  std::sort(facets_.begin(), facets_.end(), [](const Facet& a, const Facet& b) { return a.hash < b.hash; });
}

template <int D>
bool LiftedStar<D>::insert(const Lift& p) {
  const typename StarFilter<D>::Offset seen = filter_.see(p.x);
  gone_.clear();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const std::optional<Sign> quick = filter_.insphere(cells_[i].sphere, seen);
    if (quick ? *quick == Sign::positive : predicates_->conflict_sos(cells_[i].lifts, p)) {
      gone_.push_back(cells_[i]);
    } else {
      if (kept != i) cells_[kept] = cells_[i];
      ++kept;
    }
  }
  if (gone_.empty()) return false;
  cells_.resize(kept);
  collect_facets();
  for (std::size_t i = 0; i < facets_.size();) {
    std::size_t end = i + 1;
    while (end < facets_.size() && facets_[end].hash == facets_[i].hash) ++end;
    for (std::size_t j = i; j < end; ++j) {
      bool is_shared = false;
      for (std::size_t k = i; k < end; ++k)
        is_shared = is_shared || (k != j && same_points(facets_[j], facets_[k]));
      if (is_shared) continue;
      std::array<Lift, D + 1> lifts = gone_[facets_[j].cell].lifts;
      lifts[facets_[j].opposite] = p;
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
