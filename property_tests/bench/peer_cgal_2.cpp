#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>
#include <CGAL/Periodic_2_triangulation_hierarchy_2.h>
#include <CGAL/Triangulation_hierarchy_vertex_base_2.h>

#include <stdexcept>

#include "peer_cgal.hpp"

namespace flatdt::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>;
using Triangulation = CGAL::Periodic_2_Delaunay_triangulation_2<Traits>;
// The hierarchy keeps links between its levels in the vertices.
using HierarchyVertex =
    CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Periodic_2_triangulation_vertex_base_2<Traits>>;
using HierarchyStructure =
    CGAL::Triangulation_data_structure_2<HierarchyVertex, CGAL::Periodic_2_triangulation_face_base_2<Traits>>;
using Hierarchy = CGAL::Periodic_2_triangulation_hierarchy_2<
    CGAL::Periodic_2_Delaunay_triangulation_2<Traits, HierarchyStructure>>;

std::vector<Kernel::Point_2> converted(const PointSet& set) {
  std::vector<Kernel::Point_2> points;
  points.reserve(set.points.size());
  for (const Point& p : set.points) points.emplace_back(p[0], p[1]);
  return points;
}

Kernel::Iso_rectangle_2 domain(const PointSet& set) {
  return {0, 0, set.period, set.period};
}

template <class Made>
Done done(std::shared_ptr<const Made> made) {
  const std::size_t cells = made->number_of_faces();
  return {std::move(made), cells};
}

}  // namespace

Work cgal_batch_2(const PointSet& set) {
  return [points = converted(set), square = domain(set)] {
    auto made = std::make_shared<Triangulation>(square);
    made->insert(points.begin(), points.end(), true);
    return done<Triangulation>(std::move(made));
  };
}

Work cgal_hierarchy_2(const PointSet& set) {
  return [points = converted(set), square = domain(set)] {
    auto made = std::make_shared<Hierarchy>(square);
    made->insert(points.begin(), points.end());
    return done<Hierarchy>(std::move(made));
  };
}

Work cgal_one_by_one_2(const PointSet& set) {
  return [points = converted(set), square = domain(set)] {
    auto made = std::make_shared<Triangulation>(square);
    for (const Kernel::Point_2& p : points) made->insert(p);
    return done<Triangulation>(std::move(made));
  };
}

Work cgal_validity_2(const PointSet& set) {
  auto made = std::make_shared<Triangulation>(domain(set));
  const std::vector<Kernel::Point_2> points = converted(set);
  made->insert(points.begin(), points.end(), true);
  return [made] {
    if (!made->is_valid()) throw std::runtime_error("CGAL calls its own triangulation invalid");
    return Done{nullptr, made->number_of_faces()};
  };
}

}  // namespace flatdt::bench
