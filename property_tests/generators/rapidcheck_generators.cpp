#include "flatdt/testing/rapidcheck_generators.hpp"

#include <ostream>
#include <utility>

#include "flatdt/ref/triangulate.hpp"
#include "simplify.hpp"

namespace flatdt::testing {
namespace {

/// One manifold in catalogue coordinates, with its canonical metric.
Domain plain_domain(const std::string& manifold) {
  static_cast<void>(
      empty_specimen(manifold));  // refuses an unknown name here, not in the middle of a property
  Domain domain;
  domain.manifolds = {manifold};
  domain.other_metrics = false;
  domain.other_coordinates = false;
  return domain;
}

void write_metric(std::ostream& out, const ref::Matrix& gram) {
  out << "metric";
  for (int i = 0; i < gram.dimension(); ++i)
    for (int j = i; j < gram.dimension(); ++j) out << ' ' << gram(i, j).to_string();
  out << '\n';
}

}  // namespace

rc::Gen<Specimen> specimens(const Domain& domain) {
  return [domain](const rc::Random& random, int size) {
    rc::Random source = random;
    return rc::shrinkable::shrinkRecur(
        draw_specimen(domain, source.next(), size),
        [domain](const Specimen& s) { return rc::seq::fromContainer(simpler(s, domain)); });
  };
}

std::ostream& operator<<(std::ostream& out, const TriangulatedSpecimen& both) {
  return out << both.specimen << "# triangulation\n" << ref::write_triangulation(both.triangulation, {});
}

rc::Gen<TriangulatedSpecimen> triangulated_specimens(const Domain& domain) {
  return rc::gen::map(specimens(domain), [](Specimen&& s) {
    const ref::Instance instance = instance_of(s);
    auto result = ref::triangulate(instance, ref::analyse(instance), {});
    return TriangulatedSpecimen{std::move(s), std::move(result.triangulation)};
  });
}

std::ostream& operator<<(std::ostream& out, const Group& group) {
  out << "dimension " << group.gram.dimension() << "\nmanifold " << group.manifold << "\ngenerators "
      << group.generators.size() << '\n';
  for (const ref::Isometry& g : group.generators) out << "  " << g.to_string() << '\n';
  write_metric(out, group.gram);
  return out;
}

rc::Gen<Group> groups(const Domain& domain) {
  return rc::gen::map(specimens(domain), [](const Specimen& s) {
    const ref::Instance instance = instance_of(s);
    return Group{name_of(s), instance.generators, instance.gram};
  });
}

std::ostream& operator<<(std::ostream& out, const Metric& metric) {
  write_metric(out, metric.gram);
  return out;
}

rc::Gen<Metric> metrics(const std::string& manifold, long max_stretch) {
  Domain domain = plain_domain(manifold);
  domain.other_metrics = true;
  domain.max_stretch_in_plane = domain.max_stretch_in_space = max_stretch;
  domain.max_points_in_plane = domain.max_points_in_space = 1;
  return rc::gen::map(specimens(domain), [](const Specimen& s) { return Metric{s.gram}; });
}

std::ostream& operator<<(std::ostream& out, const PointSet& set) {
  out << "points " << set.points.size() << '\n';
  for (const ref::Vector& x : set.points) out << "  " << x.to_string() << '\n';
  return out;
}

rc::Gen<PointSet> point_sets(const std::string& manifold, long max_points) {
  Domain domain = plain_domain(manifold);
  domain.max_points_in_plane = domain.max_points_in_space = max_points;
  return rc::gen::map(specimens(domain), [](const Specimen& s) { return PointSet{s.points}; });
}

}  // namespace flatdt::testing
