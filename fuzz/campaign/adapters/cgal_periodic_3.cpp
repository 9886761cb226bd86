// CGAL's Periodic_3_Delaunay_triangulation_3 on the unit cube torus.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <CGAL/Random.h>

#include <map>
#include <sstream>

#include "cgal_options.hpp"

namespace flatdt::adapters {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using Triangulation = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;
using Point = Triangulation::Point;

Point point_of(const Place& p) {
  return {p[0], p[1], p[2]};
}

void insert(Triangulation& t, const std::vector<Place>& places, Insertion insertion) {
  std::vector<Point> points;
  for (const Place& p : places) points.push_back(point_of(p));
  if (insertion == Insertion::range || insertion == Insertion::large) {
    t.insert(points.begin(), points.end(), insertion == Insertion::large);
    return;
  }
  // Only originals may be removed, and which vertex is one changes with the number of sheets: they are found
  // again by their points.
  std::vector<Point> passing;
  if (insertion == Insertion::churn)
    for (const Place& p : passing_places(places, 3)) {
      passing.push_back(point_of(p));
      t.insert(passing.back());
    }
  for (const Point& p : points) t.insert(p);
  for (const Point& p : passing) {
    auto vertex = t.unique_vertices_begin();
    while (vertex != t.unique_vertices_end() && vertex->point() != p) ++vertex;
    if (vertex != t.unique_vertices_end()) t.remove(vertex);
  }
}

TorusCells triangulate(const std::vector<Place>& places, const CgalOptions& options) {
  CGAL::get_default_random() = CGAL::Random(0);  // shuffles, the same for every instance
  Triangulation t(Triangulation::Iso_cuboid(0, 0, 0, 1, 1, 1));
  insert(t, places, options.insertion);
  const bool one = t.number_of_sheets()[0] == 1;
  if (options.sheets == Sheets::one && !one && t.is_triangulation_in_1_sheet())
    t.convert_to_1_sheeted_covering();
  if (options.sheets == Sheets::all && one) t.convert_to_27_sheeted_covering();
  if (options.stream) {
    std::ostringstream out;
    out.precision(17);
    out << t;
    return {{}, {}, out.str()};
  }
  std::map<Place, std::size_t> numbers;
  for (std::size_t i = 0; i < places.size(); ++i) numbers[places[i]] = i;
  TorusCells result;
  for (std::size_t axis = 0; axis < 3; ++axis) result.sheets[axis] = t.number_of_sheets()[axis];
  for (auto c = t.cells_begin(); c != t.cells_end(); ++c) {
    auto& cell = result.cells.emplace_back();
    for (int i = 0; i < 4; ++i) {
      const auto lift = t.periodic_point(c, i);
      cell[static_cast<std::size_t>(i)] = {numbers.at({lift.first.x(), lift.first.y(), lift.first.z()}),
                                           {lift.second.x(), lift.second.y(), lift.second.z()}};
    }
  }
  return result;
}

}  // namespace
}  // namespace flatdt::adapters

int main(int argc, char** argv) {
  return flatdt::adapters::run_cgal_adapter("flatdt-cgal-3", argc, argv, 3, flatdt::adapters::triangulate);
}
