/// Properties with RapidCheck: random instances; one that fails is shrunk to few points with short numbers,
/// and printed as a file. RC_PARAMS="seed=1 max_success=1000" chooses seed and number of cases.
#include <sstream>

#include "flatdt/ref/instance_format.hpp"
#include "flatdt/testing/explain.hpp"
#include "flatdt/testing/rapidcheck_generators.hpp"
#include "my_triangulation.hpp"

using namespace flatdt::testing;

void require_delaunay(const std::string& instance) {
  const std::string witness = explain(instance, my_triangulation(instance));
  if (!witness.empty()) RC_FAIL(witness);
}

int main() {
  Domain domain;  // what your program can do: manifolds, numbers of points, metrics
  domain.manifolds = all_manifolds();
  domain.max_points_in_plane = 6;
  domain.max_points_in_space = 2;
  const bool all_manifolds_right = rc::check("triangulations are Delaunay on every manifold", [&] {
    const Specimen specimen = *specimens(domain).as("instance");
    require_delaunay(flatdt::ref::write_instance(instance_of(specimen)));
  });

  // Instances put together by hand: any metric of the Klein bottle, any points.
  const bool metrics_right = rc::check("triangulations are Delaunay for every metric", [] {
    std::ostringstream instance;
    instance << "flatdt-instance 1\ndimension 2\nmanifold klein-bottle\n"
             << *metrics("klein-bottle", 5).as("metric") << *point_sets("klein-bottle", 4).as("points");
    require_delaunay(instance.str());
  });
  return all_manifolds_right && metrics_right ? 0 : 1;
}
