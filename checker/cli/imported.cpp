#include "imported.hpp"

#include "../importers/cgal_stream.hpp"
#include "flatdt/checker/check.hpp"

namespace flatdt::checker {

std::vector<std::string> import_formats() {
  return {"cgal-p2t2", "cgal-p3t3"};
}

Verdict judge_imported(std::istream& in, const std::string& file, const std::string& format,
                       std::string& note) {
  const Imported imported = import_cgal(in, file, format == "cgal-p2t2" ? 2 : 3);
  note = imported.note;
  return check(imported.instance, imported.triangulation);
}

}  // namespace flatdt::checker
