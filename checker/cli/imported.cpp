#include "imported.hpp"

namespace flatdt::checker {

std::vector<std::string> import_formats() {
  return {"cgal-p2t2", "cgal-p3t3"};
}

Imported import_file(std::istream& in, const std::string& file, const std::string& format) {
  return import_cgal(in, file, format == "cgal-p2t2" ? 2 : 3);
}

}  // namespace flatdt::checker
