#include "flatdt/ref/delaunay_hierarchy.hpp"

#include <algorithm>

#include "flatdt/ref/first_orbit.hpp"

namespace flatdt::ref {

template <int D>
void DelaunayHierarchy<D>::start_level(SiteId site) {
  levels_.emplace_back(setting_, cover_, insertion_);
  levels_.back().start(site, triangulate_first_orbit<D>(*setting_.frame, *setting_.table, *setting_.sites,
                                                        *setting_.order, *setting_.predicates, site));
}

template <int D>
void DelaunayHierarchy<D>::convert_if_possible(std::size_t level) {
  if (insertion_ == Insertion::without_covers) return;
  // Step 2 of Section 4.1.
  if (levels_[level].is_on_manifold() || levels_[level].large_cells() > 0) return;
  levels_[level].convert_to_manifold();
  if (level == 0) switched_after_ = orbits_;
}

template <int D>
void DelaunayHierarchy<D>::insert_copy(SiteId site, std::uint32_t rep, std::size_t highest) {
  const Element query = cover_.representative(rep);
  const Lift lift = levels_.front().complex().lift(OrbitPoint{site, query});
  OrbitPoint near = levels_.back().start_near(lift);
  std::vector<Location> at(levels_.size());
  for (std::size_t level = levels_.size(); level-- > 0;) {
    if (rep > 0 && levels_[level].is_on_manifold()) break;  // one copy is enough here and below
    at[level] = levels_[level].locate(site, query, near);
    if (level > 0) near = levels_[level].nearest_vertex(site, query, at[level]);
  }
  for (std::size_t level = 0; level <= highest; ++level)
    if (at[level].cell != kNoCell) levels_[level].insert(site, rep, at[level]);
}

template <int D>
void DelaunayHierarchy<D>::insert_orbit(SiteId site, std::size_t top) {
  ++orbits_;
  if (levels_.empty()) {
    start_level(site);
    convert_if_possible(0);
    return;
  }
  const std::size_t highest = std::min(top, levels_.size() - 1);
  std::uint32_t copies = 0;
  for (std::size_t level = 0; level <= highest; ++level) {
    levels_[level].add_site(site);
    copies = std::max(copies, levels_[level].copies());
  }
  for (std::uint32_t rep = 0; rep < copies; ++rep) insert_copy(site, rep, highest);
  for (std::size_t level = 0; level <= highest; ++level) convert_if_possible(level);
  if (top > highest) start_level(site);
}

template class DelaunayHierarchy<2>;
template class DelaunayHierarchy<3>;

}  // namespace flatdt::ref
