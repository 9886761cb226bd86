#include <cstdio>

#include "commands.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/svg.hpp"
#include "group_report.hpp"
#include "text_files.hpp"

namespace flatdt::ref::cli {

int run_draw(const DrawOptions& options) {
  if (options.instance == "-" && options.triangulation == "-")
    throw InvalidInput("standard input can be read once only: give one of the files by name");
  const Instance instance = parse_instance(read_input(options.instance), options.instance);
  if (instance.dimension != 2)
    throw InvalidInput(options.instance + ": draw is for dimension 2, this instance has dimension " +
                       std::to_string(instance.dimension));
  static_cast<void>(analysed(instance, options.instance));  // an inadmissible group is refused with its line
  const Triangulation triangulation = parse_triangulation(
      read_input(options.triangulation), options.triangulation, instance.dimension, instance.points.size());
  const Drawing drawing = draw_svg(instance, triangulation, {options.show_two_cycle, options.show_violation});
  for (const std::string& note : drawing.notes) std::fprintf(stderr, "%s\n", note.c_str());
  write_output(options.output, drawing.svg);
  return 0;
}

}  // namespace flatdt::ref::cli
