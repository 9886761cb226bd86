#include "peer_cgal.hpp"

#include <CGAL/version.h>

#include <stdexcept>

namespace flatdt::bench {

std::string peer_version() {
  return "CGAL " CGAL_VERSION_STR;
}
Work peer_batch(const PointSet& set) {
  return set.dimension == 2 ? cgal_batch_2(set) : cgal_batch_3(set);
}
Work peer_hierarchy(const PointSet& set) {
  if (set.dimension != 2) throw std::logic_error("the periodic hierarchy in space is not measured");
  return cgal_hierarchy_2(set);
}
Work peer_one_by_one(const PointSet& set) {
  return set.dimension == 2 ? cgal_one_by_one_2(set) : cgal_one_by_one_3(set);
}
Work peer_validity(const PointSet& set) {
  return set.dimension == 2 ? cgal_validity_2(set) : cgal_validity_3(set);
}

}  // namespace flatdt::bench
