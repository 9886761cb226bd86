#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <stdexcept>

#include "peer_cgal.hpp"

namespace flatdt::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using Triangulation = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;

std::vector<Triangulation::Point> converted(const PointSet& set) {
  std::vector<Triangulation::Point> points;
  points.reserve(set.points.size());
  for (const Point& p : set.points) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

Triangulation::Iso_cuboid domain(const PointSet& set) {
  return {0, 0, 0, set.period, set.period, set.period};
}

Done done(std::shared_ptr<const Triangulation> made) {
  const std::size_t cells = made->number_of_cells();
  return {std::move(made), cells};
}

}  // namespace

Work cgal_batch_3(const PointSet& set) {
  return [points = converted(set), cube = domain(set)] {
    auto made = std::make_shared<Triangulation>(cube);
    made->insert(points.begin(), points.end(), true);
    return done(std::move(made));
  };
}

Work cgal_one_by_one_3(const PointSet& set) {
  return [points = converted(set), cube = domain(set)] {
    auto made = std::make_shared<Triangulation>(cube);
    for (const Triangulation::Point& p : points) made->insert(p);
    return done(std::move(made));
  };
}

Work cgal_validity_3(const PointSet& set) {
  auto made = std::make_shared<Triangulation>(domain(set));
  const std::vector<Triangulation::Point> points = converted(set);
  made->insert(points.begin(), points.end(), true);
  return [made] {
    if (!made->is_valid()) throw std::runtime_error("CGAL calls its own triangulation invalid");
    return Done{nullptr, made->number_of_cells()};
  };
}

}  // namespace flatdt::bench
