#include "finite_star.hpp"

#include <algorithm>
#include <deque>
#include <map>

namespace flatdt::ref {
namespace {

Lift make_lift(const GroupTable& table, const std::vector<Site>& sites, const OrbitPoint& p) {
  return {table.apply(p.g, sites[index_of(p.site)].approximate()), p};
}

}  // namespace

template <int D>
FiniteStar<D>::FiniteStar(const GroupTable& table, const std::vector<Site>& sites, Predicates<D>& predicates,
                          const OrbitPoint& q, const std::vector<OrbitPoint>& candidates)
    : predicates_(&predicates),
      q_(make_lift(table, sites, q)),
      filter_(predicates.filter(), q_.x, predicates.uses_filter()) {
  candidates_.reserve(candidates.size());
  offsets_.reserve(candidates.size());
  for (const OrbitPoint& p : candidates) {
    candidates_.push_back(make_lift(table, sites, p));
    offsets_.push_back(filter_.see(candidates_.back().x));
  }
}

template <int D>
std::array<Lift, D + 1> FiniteStar<D>::lifts(const Apexes& apexes) const {
  std::array<Lift, D + 1> cell;
  cell[0] = q_;
  for (std::size_t k = 0; k < D; ++k) cell[k + 1] = candidates_[apexes[k]];
  return cell;
}

template <int D>
Sign FiniteStar<D>::orientation(const Apexes& apexes) const {
  return orientation(plane(apexes, D - 1), apexes, D - 1);
}

template <int D>
typename StarFilter<D>::Plane FiniteStar<D>::plane(const Apexes& apexes, std::size_t opposite) const {
  std::array<typename StarFilter<D>::Offset, D - 1> others;
  for (std::size_t k = 0, i = 0; k < D; ++k)
    if (k != opposite) others[i++] = offsets_[apexes[k]];
  return filter_.plane(others);
}

template <int D>
Sign FiniteStar<D>::orientation(const typename StarFilter<D>::Plane& plane, const Apexes& apexes,
                                std::size_t opposite) const {
  const std::optional<Sign> last = filter_.orientation(plane, offsets_[apexes[opposite]]);
  if (!last) return predicates_->orientation(lifts(apexes));
  return (D - 1 - opposite) % 2 == 0 ? *last : -*last;
}

template <int D>
typename FiniteStar<D>::Ball FiniteStar<D>::ball(const Apexes& apexes) const {
  std::array<typename StarFilter<D>::Offset, D> others;
  for (std::size_t k = 0; k < D; ++k) others[k] = offsets_[apexes[k]];
  const bool is_negative = orientation(apexes) == Sign::negative;
  Ball result{lifts(apexes), filter_.sphere(others, is_negative)};
  if (is_negative) std::swap(result.lifts[0], result.lifts[1]);
  return result;
}

template <int D>
bool FiniteStar<D>::in_conflict(const Ball& ball, std::size_t candidate) const {
  const std::optional<Sign> quick = filter_.insphere(ball.sphere, offsets_[candidate]);
  return quick ? *quick == Sign::positive : predicates_->conflict_sos(ball.lifts, candidates_[candidate]);
}

/// Is the ray u = (1, e, e^2, ...), e infinitesimal, inside the cone of the apexes at q? By Cramer: replacing
/// apex k by q + u must give the sign of the determinant, for every k; with u in place the determinant's sign
/// is that of its first nonzero coefficient: of q + e_i, candidate i, in place.
template <int D>
bool FiniteStar<D>::contains_ray(const Apexes& apexes) const {
  const Sign whole = orientation(apexes);
  if (whole == Sign::zero) return false;
  for (std::size_t k = 0; k < D; ++k) {
    Sign sign = Sign::zero;
    for (std::size_t i = 0; i < D && sign == Sign::zero; ++i) {
      Apexes replaced = apexes;
      replaced[k] = i;
      if (std::count(replaced.begin(), replaced.end(), i) == 1) sign = orientation(replaced);
    }
    if (sign != whole) return false;
  }
  return true;
}

template <int D>
typename FiniteStar<D>::Apexes FiniteStar<D>::first_cell() {
  Apexes cell{};
  for (std::size_t k = 0; k < D; ++k) cell[k] = k;
  ensure(contains_ray(cell), "the first candidates' cone contains the ray");
  // Simplex method: every pivot strictly lowers the perturbed lifted height beside q on the ray, so no cell
  // recurs and the loop ends; a candidate in conflict always leaves exactly one cell that contains the ray
  // (ratio test).
  for (bool improved = true; improved;) {
    improved = false;
    Ball around = ball(cell);
    for (std::size_t w = 0; w < candidates_.size(); ++w) {
      if (std::find(cell.begin(), cell.end(), w) != cell.end()) continue;
      if (!in_conflict(around, w)) continue;
      std::size_t leaving = D;
      for (std::size_t k = 0; k < D; ++k) {
        Apexes next = cell;
        next[k] = w;
        if (contains_ray(next)) leaving = k;
      }
      ensure(leaving < D, "a point in conflict can enter the basis");
      cell[leaving] = w;
      around = ball(cell);
      improved = true;
    }
  }
  return cell;
}

template <int D>
typename FiniteStar<D>::Apexes FiniteStar<D>::wrap(const Apexes& apexes, std::size_t opposite) {
  const typename StarFilter<D>::Plane facet = plane(apexes, opposite);
  const Sign side = orientation(facet, apexes, opposite);
  std::size_t best = candidates_.size();
  Apexes cell = apexes;
  Ball around{};
  for (std::size_t w = 0; w < candidates_.size(); ++w) {
    if (std::find(apexes.begin(), apexes.end(), w) != apexes.end()) continue;
    Apexes next = apexes;
    next[opposite] = w;
    if (orientation(facet, next, opposite) != -side) continue;
    if (best != candidates_.size() && !in_conflict(around, w)) continue;
    best = w;
    cell = next;
    around = ball(cell);
  }
  ensure(best != candidates_.size(), "q is in the interior of the candidates' convex hull");
  return cell;
}

template <int D>
std::vector<CellPoints<D>> FiniteStar<D>::cells() {
  std::set<std::array<std::size_t, D>> found;
  std::map<std::array<std::size_t, D - 1>, int> facets;  // cells seen on a facet through q
  std::deque<Apexes> open;
  const auto facet_of = [](const Apexes& cell, std::size_t opposite) {
    std::array<std::size_t, D - 1> facet{};
    for (std::size_t j = 0, i = 0; j < D; ++j)
      if (j != opposite) facet[i++] = cell[j];
    return facet;  // sorted, since cells are
  };
  const auto take = [&](Apexes cell) {
    std::sort(cell.begin(), cell.end());
    if (!found.insert(cell).second) return;
    for (std::size_t k = 0; k < D; ++k) ++facets[facet_of(cell, k)];
    open.push_back(cell);
  };
  take(first_cell());
  // Bounded: a finite set has finitely many cells and each is opened once.
  while (!open.empty()) {
    const Apexes cell = open.front();
    open.pop_front();
    for (std::size_t k = 0; k < D; ++k)
      if (facets[facet_of(cell, k)] < 2) take(wrap(cell, k));
  }
  for (const auto& [facet, count] : facets) ensure(count == 2, "the star of q is closed");
  std::vector<CellPoints<D>> result;
  for (const auto& cell : found) {
    CellPoints<D> points;
    points[0] = q_.point;
    for (std::size_t k = 0; k < D; ++k) points[k + 1] = candidates_[cell[k]].point;
    result.push_back(points);
  }
  return result;
}

template class FiniteStar<2>;
template class FiniteStar<3>;

}  // namespace flatdt::ref
