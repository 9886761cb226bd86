/// Stands in for CGAL where it is not installed.
#include <stdexcept>

#include "peer.hpp"

namespace flatdt::bench {
namespace {

[[noreturn]] void absent() {
  throw std::logic_error("built without CGAL");
}

}  // namespace

std::string peer_version() {
  return "";
}
Work peer_batch(const PointSet& /*set*/) {
  absent();
}
Work peer_hierarchy(const PointSet& /*set*/) {
  absent();
}
Work peer_one_by_one(const PointSet& /*set*/) {
  absent();
}
Work peer_validity(const PointSet& /*set*/) {
  absent();
}

}  // namespace flatdt::bench
