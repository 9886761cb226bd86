/// The answer in the instance's terms: its points, its coordinates, its group's elements.
#pragma once

#include <optional>
#include <vector>

#include "flatdt/ref/prepared_group.hpp"
#include "flatdt/ref/quotient_complex.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::ref {

/// Group elements of the internal frame, applied to sites, as elements of the instance applied to its points.
class InstanceElements {
 public:
  InstanceElements(const PreparedGroup& group, const std::vector<Site>& sites);

  /// The element e of the instance's group with e * points[site.point] = p.
  [[nodiscard]] Isometry at(const OrbitPoint& p) const;
  /// For an edge from site a to g * (site b): the element e with the edge from points[a] to e * points[b].
  [[nodiscard]] Isometry between(SiteId a, const OrbitPoint& b) const;
  /// An element of the frame's group in the instance's coordinates.
  [[nodiscard]] Isometry conjugate(const Isometry& g) const {
    return group_->to_instance() * g * group_->to_instance().inverse();
  }

  /// The same as at(), in the frame and in machine integers; nothing, of every p, if some site is large and
  /// its element does not fit: moves by more than 2^48.
  struct FrameElement {
    std::array<std::int64_t, 3> translation{};
    std::uint16_t coset = 0;
    friend bool operator==(const FrameElement&, const FrameElement&) = default;
  };
  [[nodiscard]] std::optional<FrameElement> in_frame(const OrbitPoint& p) const;

  [[nodiscard]] const Site& site(SiteId id) const { return (*sites_)[index_of(id)]; }
  [[nodiscard]] const PreparedGroup& group() const { return *group_; }

 private:
  const PreparedGroup* group_;
  const std::vector<Site>* sites_;
  /// Of large sites, the elements with p = element * site; none if one of them does not fit.
  std::vector<FrameElement> large_;
};

/// Cells of GP as cells of the instance's points, elements numbered as they come.
/// Complexity: O(number of vertices), and some rational arithmetic for each distinct element. The list's
/// memory is given back while the triangulation's is taken, so that there is one of them at a time.
template <int D>
Triangulation to_triangulation(CellList<D> cells, const InstanceElements& elements);

extern template Triangulation to_triangulation<2>(CellList<2>, const InstanceElements&);
extern template Triangulation to_triangulation<3>(CellList<3>, const InstanceElements&);

}  // namespace flatdt::ref
