/// The answer in the instance's terms: its points, its coordinates, its group's elements.
#pragma once

#include <vector>

#include "flatdt/ref/quotient_complex.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::ref {

/// Group elements of the internal frame, applied to sites, as elements of the instance applied to its points.
class InstanceElements {
 public:
  InstanceElements(const Frame& frame, const std::vector<Site>& sites, const GroupTable& table)
      : frame_(&frame),
        table_(&table),
        sites_(&sites),
        to_instance_{frame.basis, frame.origin},
        from_instance_(to_instance_.inverse()) {}

  /// The element e of the instance's group with e * points[site.point] = p.
  [[nodiscard]] Isometry at(const OrbitPoint& p) const {
    return to_instance_ * table_->isometry(p.g) * site(p.site).from_site(*frame_).inverse() * from_instance_;
  }
  /// For an edge from site a to g * (site b): the element e with the edge from points[a] to e * points[b].
  [[nodiscard]] Isometry between(SiteId a, const OrbitPoint& b) const {
    return to_instance_ * site(a).from_site(*frame_) * table_->isometry(b.g) *
           site(b.site).from_site(*frame_).inverse() * from_instance_;
  }
  [[nodiscard]] Isometry conjugate(const Isometry& g) const { return to_instance_ * g * from_instance_; }

  [[nodiscard]] const Site& site(SiteId id) const { return (*sites_)[index_of(id)]; }
  [[nodiscard]] const GroupTable& table() const { return *table_; }

 private:
  const Frame* frame_;
  const GroupTable* table_;
  const std::vector<Site>* sites_;
  Isometry to_instance_;
  Isometry from_instance_;
};

/// Cells of GP as cells of the instance's points, elements numbered as they come.
/// Complexity: O(number of vertices), and products of rational matrices for each distinct element.
template <int D>
Triangulation to_triangulation(const std::vector<CellPoints<D>>& cells, const InstanceElements& elements);

extern template Triangulation to_triangulation<2>(const std::vector<CellPoints<2>>&, const InstanceElements&);
extern template Triangulation to_triangulation<3>(const std::vector<CellPoints<3>>&, const InstanceElements&);

}  // namespace flatdt::ref
