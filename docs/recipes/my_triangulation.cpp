#include "my_triangulation.hpp"

#include <cstdlib>

#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/triangulate.hpp"

// Put your own program here: parse the instance (docs/format.md), triangulate, print the cells. Until then
// the reference stands in for it. LEAVE_OUT_A_CELL=1 shows what a failing test looks like.
std::string my_triangulation(const std::string& instance_text) {
  using namespace flatdt::ref;
  const Instance instance = parse_instance(instance_text, "instance");
  Triangulation triangulation = triangulate(instance, analyse(instance), {}).triangulation;
  if (std::getenv("LEAVE_OUT_A_CELL") != nullptr) triangulation.cells.pop_back();
  return write_triangulation(triangulation, {});
}
