/// `flatdt info`: the group analysis of an instance.
#include "commands.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "group_report.hpp"
#include "text_files.hpp"

namespace flatdt::ref::cli {
namespace {

/// x_instance = map x_catalogue.
Isometry from_catalogue(const Frame& frame) {
  return {frame.basis * frame.to_catalogue.inverse(), frame.origin};
}

std::string space_group(const Frame& frame) {
  return frame.entry->space_groups[frame.mirrored ? 1 : 0];
}

std::string handedness(const Frame& frame) {
  if (frame.entry->mirror_image_generators.empty()) return "none: the group is its own mirror image";
  return std::string(frame.mirrored ? "left" : "right") + ", if the coordinates are right-handed";
}

std::string line(const std::string& label, const std::string& value) {
  constexpr std::size_t kWidth = 26;
  return label + std::string(kWidth - label.size(), ' ') + value + "\n";
}

std::string rows_text(const Matrix& m) {
  std::string text;
  for (int i = 0; i < m.dimension(); ++i) {
    text += " ";
    for (int j = 0; j < m.dimension(); ++j) text += " " + m(i, j).to_string();
    text += "\n";
  }
  return text;
}

std::string text_report(const Instance& instance, const GroupAnalysis& analysis) {
  const Frame& frame = analysis.frame;
  const CatalogueEntry& entry = *analysis.entry;
  const Sheets sheets = sheets_of(frame);
  std::string text = line("manifold", entry.name);
  text += line("aliases", joined(entry.aliases, ", "));
  text += line("dimension", std::to_string(entry.dimension));
  text += line("group", space_group(frame));
  text += line("handedness", handedness(frame));
  text += line("orientable", analysis.orientable ? "yes" : "no");
  text += line("holonomy", entry.holonomy + ", order " + std::to_string(analysis.holonomy_order));
  text += line("H1", homology_text(analysis.h1));
  text += line("volume^2", analysis.volume_squared.to_string());
  text += line("delta^2", frame.delta_squared.to_string());
  text += line("sheets, Theorem 10", sheets.theorem10);
  text += line("sheets, one at a time", sheets.one_at_a_time);
  text += line("sheets, complete orbits", sheets.complete_orbits);
  text += line("points in the file", std::to_string(instance.points.size()));
  text += "translation lattice, the columns of its Hermite normal form:\n" + rows_text(analysis.lattice);
  text += "one element [R|t] of each coset of the translations:\n";
  for (const Isometry& g : analysis.cosets) text += "  " + g.to_string() + "\n";
  text += "metric (Gram matrix of the coordinates):\n" + rows_text(instance.gram);
  text += "reduced basis of the lattice, columns:\n" + rows_text(frame.basis);
  text += "Gram matrix of the reduced basis:\n" + rows_text(frame.gram);
  text += "from catalogue coordinates to those of the file, [A|o]:\n  " + from_catalogue(frame).to_string() +
          "\n";
  return text;
}

Json json_report(const Instance& instance, const GroupAnalysis& analysis) {
  const Frame& frame = analysis.frame;
  Json json = {{"schema", "flatdt-info 1"}};
  json.update(json_of_names(*analysis.entry));
  json["group"] = space_group(frame);
  json["mirror_image"] = frame.mirrored;
  json["volume_squared"] = analysis.volume_squared.to_string();
  json["delta_squared"] = frame.delta_squared.to_string();
  json["sheets"] = json_of(sheets_of(frame));
  json["points"] = std::to_string(instance.points.size());
  json["lattice"] = json_of(analysis.lattice);
  json["cosets"] = json_of(analysis.cosets);
  json["gram"] = json_of(instance.gram);
  json["reduced_basis"] = json_of(frame.basis);
  json["reduced_gram"] = json_of(frame.gram);
  json["from_catalogue"] = json_of(from_catalogue(frame));
  return json;
}

}  // namespace

int run_info(const InfoOptions& options) {
  const std::string file_name = options.instance == "-" ? "<stdin>" : options.instance;
  const Instance instance = parse_instance(read_input(options.instance), file_name);
  const GroupAnalysis analysis = analysed(instance, file_name);
  write_output(
      "-", options.json ? json_report(instance, analysis).dump(1) + "\n" : text_report(instance, analysis));
  return 0;
}

}  // namespace flatdt::ref::cli
