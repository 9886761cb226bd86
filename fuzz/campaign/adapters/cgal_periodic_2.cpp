// CGAL's Periodic_2_Delaunay_triangulation_2 on the unit square torus.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>
#include <CGAL/Random.h>

#include <map>
#include <sstream>

#include "cgal_options.hpp"

namespace flatdt::adapters {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>;
using Triangulation = CGAL::Periodic_2_Delaunay_triangulation_2<Traits>;
using Point = Triangulation::Point;

Point point_of(const Place& p) {
  return {p[0], p[1]};
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
    for (const Place& p : passing_places(places, 2)) {
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
  Triangulation t(Triangulation::Iso_rectangle(0, 0, 1, 1));
  insert(t, places, options.insertion);
  if (options.sheets == Sheets::one && !t.is_1_cover() && t.is_triangulation_in_1_sheet())
    t.convert_to_1_sheeted_covering();
  if (options.sheets == Sheets::all && t.is_1_cover()) t.convert_to_9_sheeted_covering();
  if (options.stream) {
    std::ostringstream out;
    out.precision(17);
    out << t;
    return {{}, {}, out.str()};
  }
  std::map<Place, std::size_t> numbers;
  for (std::size_t i = 0; i < places.size(); ++i) numbers[places[i]] = i;
  TorusCells result;
  for (int axis = 0; axis < 2; ++axis)
    result.sheets[static_cast<std::size_t>(axis)] = t.number_of_sheets()[static_cast<std::size_t>(axis)];
  for (auto face = t.faces_begin(); face != t.faces_end(); ++face) {
    auto& cell = result.cells.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto lift = t.periodic_point(face, i);
      cell[static_cast<std::size_t>(i)] = {numbers.at({lift.first.x(), lift.first.y(), 0}),
                                           {lift.second.x(), lift.second.y(), 0}};
    }
  }
  return result;
}

}  // namespace
}  // namespace flatdt::adapters

int main(int argc, char** argv) {
  return flatdt::adapters::run_cgal_adapter("flatdt-cgal-2", argc, argv, 2, flatdt::adapters::triangulate);
}
