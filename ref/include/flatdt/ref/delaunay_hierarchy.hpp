/// The Delaunay hierarchy (Section 4.2; [Devillers02]) over covers and the manifold.
/// Invariants: level l+1 holds a random subset of the orbits of level l; every level starts in the cover X_C
/// with its first orbit as a block and is converted to the manifold as soon as its list L is empty. Lower
/// levels have more points, so below a level on the manifold all are on it. The pointers between levels are
/// implicit: a vertex is a (site, element), and each level finds its own vertex of that coset.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "flatdt/ref/periodic_delaunay.hpp"

namespace flatdt::ref {

template <int D>
class DelaunayHierarchy {
 public:
  /// `cover`: the sublattice of the covering phase, or the tie order's invariance group without covers.
  DelaunayHierarchy(const Setting<D>& setting, const Subgroup& cover,
                    Insertion insertion = Insertion::covering)
      : setting_(setting), cover_(cover), insertion_(insertion) {}

  /// Inserts an orbit into the levels 0 .. top (a new level is made for top == number of levels): all its
  /// copies, one by one, where the level is still in the cover, else once. L is consulted after the whole
  /// orbit only.
  void insert_orbit(SiteId site, std::size_t top);

  /// Level 0: all orbits.
  [[nodiscard]] const PeriodicDelaunay<D>& full() const { return levels_.front(); }
  [[nodiscard]] QuotientComplex<D> release_complex() && {
    return std::move(levels_.front()).release_complex();
  }
  [[nodiscard]] std::size_t levels() const { return levels_.size(); }
  /// After how many orbits level 0 left the cover, if it did.
  [[nodiscard]] std::optional<std::size_t> switched_after() const { return switched_after_; }

 private:
  void start_level(SiteId site);
  void insert_copy(SiteId site, std::uint32_t rep, std::size_t highest);
  void convert_if_possible(std::size_t level);

  Setting<D> setting_;
  Subgroup cover_;
  Insertion insertion_;
  std::vector<PeriodicDelaunay<D>> levels_;
  std::size_t orbits_ = 0;
  std::optional<std::size_t> switched_after_;
};

extern template class DelaunayHierarchy<2>;
extern template class DelaunayHierarchy<3>;

}  // namespace flatdt::ref
