#include "flatdt/ref/orbit_position.hpp"

namespace flatdt::ref {

Vector position(const GroupTable& table, const std::vector<Site>& sites, const OrbitPoint& p) {
  const Site& site = sites[index_of(p.site)];
  Vector x(table.dimension());
  for (int i = 0; i < table.dimension(); ++i) x[i] = Rational(site.numerator(i), site.denominator());
  return table.isometry(p.g) * x;
}

}  // namespace flatdt::ref
