#include "rapidcheck_generators.hpp"

#include <ostream>

#include "flatdt/ref/triangulate.hpp"
#include "simplify.hpp"

namespace flatdt::testing {

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

}  // namespace flatdt::testing
