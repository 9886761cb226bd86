/// The total order on the orbit points GP that drives the symbolic perturbation (DESIGN: ties; INSERTION 1).
/// First the orbit's rank; then, within an orbit, the left order of the group, whose key is R^-1 t in the
/// catalogue's coordinate order. For the didicosm group, which is not left-orderable, the order of its
/// index-2 dicosm subgroup H: write g = h or h a; compare (0 or 1, key(h)). It is invariant under
/// `invariance_group()`: G, or H for the didicosm. Source: [DevillersTeillaud03] for the perturbation;
/// differs: their order is lexicographic, which does not commute with a glide or a screw.
#pragma once

#include <array>
#include <vector>

#include "flatdt/ref/sites.hpp"
#include "flatdt/ref/subgroup.hpp"

namespace flatdt::ref {

class TieOrder {
 public:
  TieOrder(const Frame& frame, const GroupTable& table);

  /// g * site a comes before h * site b.
  [[nodiscard]] bool less(SiteId a, const Element& g, SiteId b, const Element& h) const {
    if (a != b) return index_of(a) < index_of(b);
    return element_less(g, h);
  }
  /// The left order of the group (of H, with the coset H before H a, for the didicosm).
  [[nodiscard]] bool element_less(const Element& g, const Element& h) const;

  /// The largest subgroup under which the order is known to be invariant.
  [[nodiscard]] const Subgroup& invariance_group() const { return invariance_group_; }

 private:
  const GroupTable* table_;
  Subgroup invariance_group_;
  std::vector<bool> in_first_half_;  // by coset; all true but for the didicosm
  /// For each half: the rows, in comparison order, of the matrix that takes R^-1 t of g in the frame to the
  /// key of h in catalogue coordinates, up to a constant of the half that cancels in comparisons.
  std::array<std::vector<std::array<Integer, 3>>, 2> rows_;
  /// The same in machine integers, if all entries are below 2^31; else empty.
  std::array<std::vector<std::array<std::int64_t, 3>>, 2> small_rows_;
};

}  // namespace flatdt::ref
