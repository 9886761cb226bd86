#include "flatdt/ref/orbit_position.hpp"

namespace flatdt::ref {

Vector position(const GroupTable& table, const std::vector<Site>& sites, const OrbitPoint& p) {
  const Site& site = sites[index_of(p.site)];
  Vector x(table.dimension());
  for (int i = 0; i < table.dimension(); ++i)
    x[i] = Rational(Integer(site.numerators[static_cast<std::size_t>(i)]), Integer(site.denominator));
  return table.isometry(p.g) * x;
}

}  // namespace flatdt::ref
