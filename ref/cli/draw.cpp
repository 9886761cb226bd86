#include <algorithm>
#include <cstdio>
#include <vector>

#include "commands.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "flatdt/ref/scene.hpp"
#include "flatdt/ref/svg.hpp"
#include "group_report.hpp"
#include "text_files.hpp"
#include "verdict_file.hpp"

namespace flatdt::ref::cli {
namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// As asked for, else by the name of the output, else what suits the dimension.
std::string format_of(const DrawOptions& options, int dimension) {
  if (!options.format.empty()) return options.format;
  for (const char* format : {"svg", "vtu", "html"})
    if (ends_with(options.output, std::string(".") + format)) return format;
  return dimension == 2 ? "svg" : "vtu";
}

void require_one_standard_input(const DrawOptions& options) {
  const std::vector<std::string> inputs = {options.instance, options.triangulation, options.verdict};
  if (std::count(inputs.begin(), inputs.end(), "-") > 1)
    throw InvalidInput("standard input can be read once only: give the other files by name");
}

struct Picture {
  std::string text;
  std::vector<std::string> notes;
};

Picture drawn(const std::string& format, const Instance& instance, const Triangulation& triangulation,
              const std::optional<Verdict>& verdict, const DrawOptions& options) {
  if (format == "svg") {
    Drawing drawing = draw_svg(
        instance, triangulation,
        {options.show_two_cycle, options.show_violation, verdict, options.condition, options.copies != 0});
    return {std::move(drawing.svg), std::move(drawing.notes)};
  }
  if (options.show_violation)
    throw InvalidInput("--violation is for SVG: use --verdict with what flatdt-check --json says");
  const Scene scene =
      make_scene(instance, triangulation, {options.show_two_cycle, verdict, options.condition});
  const int copies = std::max(options.copies, 0);
  return {format == "vtu" ? vtu_text(scene, copies) : html_text(scene, copies), scene.notes};
}

}  // namespace

int run_draw(const DrawOptions& options) {
  require_one_standard_input(options);
  const Instance instance = parse_instance(read_input(options.instance), options.instance);
  const std::string format = format_of(options, instance.dimension);
  if (format == "svg" && instance.dimension != 2)
    throw InvalidInput(options.instance + ": SVG is for dimension 2, this instance has dimension " +
                       std::to_string(instance.dimension) + ": draw it as .vtu or .html");
  static_cast<void>(analysed(instance, options.instance));  // an inadmissible group is refused with its line
  const Triangulation triangulation = parse_triangulation(
      read_input(options.triangulation), options.triangulation, instance.dimension, instance.points.size());
  std::optional<Verdict> verdict;
  if (!options.verdict.empty()) verdict = parse_verdict(read_input(options.verdict), options.verdict);
  const Picture picture = drawn(format, instance, triangulation, verdict, options);
  for (const std::string& note : picture.notes) std::fprintf(stderr, "%s\n", note.c_str());
  write_output(options.output, picture.text);
  return 0;
}

}  // namespace flatdt::ref::cli
