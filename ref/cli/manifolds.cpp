/// `flatdt manifolds`: the catalogue, with delta^2 and the sheets recomputed at the canonical metric.
#include <algorithm>

#include "commands.hpp"
#include "group_report.hpp"
#include "text_files.hpp"

namespace flatdt::ref::cli {
namespace {

GroupAnalysis analysis_of(const CatalogueEntry& entry) {
  Instance instance;
  instance.dimension = entry.dimension;
  instance.name = entry.name;
  instance.generators = entry.generators;
  instance.gram = entry.canonical_gram;
  return analyse(instance);
}

/// Columns as wide as their widest cell, two blanks apart.
std::string table_text(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows[0].size());
  for (const auto& row : rows)
    for (std::size_t j = 0; j < row.size(); ++j) widths[j] = std::max(widths[j], row[j].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t j = 0; j < row.size(); ++j)
      line += row[j] + std::string(j + 1 < row.size() ? widths[j] - row[j].size() + 2 : 0, ' ');
    text += line + "\n";
  }
  return text;
}

std::string overview() {
  std::vector<std::vector<std::string>> rows = {
      {"name", "aliases", "space groups", "orientable", "holonomy", "H1", "delta^2", "sheets"}};
  for (const CatalogueEntry& entry : catalogue()) {
    const GroupAnalysis analysis = analysis_of(entry);
    const Sheets sheets = sheets_of(analysis.frame);
    rows.push_back({entry.name, joined(entry.aliases, ", "), joined(entry.space_groups, ", "),
                    entry.orientable ? "yes" : "no", entry.holonomy, homology_text(entry.h1),
                    analysis.frame.delta_squared.to_string(),
                    sheets.theorem10 + ", " + sheets.one_at_a_time + ", " + sheets.complete_orbits});
  }
  return table_text(rows);
}

std::string details(const CatalogueEntry& entry) {
  std::string text = entry.name + "\n";
  for (const Isometry& g : entry.generators) text += "  generator    " + g.to_string() + "\n";
  for (const Isometry& g : entry.mirror_image_generators)
    text += "  mirror image " + g.to_string() + "  (" + joined(entry.mirror_aliases, ", ") + ")\n";
  return text + "  metric       " + entry.metric_cone + "\n  delta^2      " + entry.delta_squared_formula +
         "\n";
}

Json json_of_entry(const CatalogueEntry& entry) {
  const GroupAnalysis analysis = analysis_of(entry);
  Json json = json_of_names(entry);
  json["generators"] = json_of(entry.generators);
  json["mirror_image_generators"] = json_of(entry.mirror_image_generators);
  json["mirror_aliases"] = entry.mirror_aliases;
  json["coset_representatives"] = json_of(entry.coset_representatives);
  json["metric_cone"] = entry.metric_cone;
  json["canonical_gram"] = json_of(entry.canonical_gram);
  json["delta_squared"] = {{"canonical", analysis.frame.delta_squared.to_string()},
                           {"formula", entry.delta_squared_formula}};
  json["left_orderable"] = entry.left_orderable;
  json["sheets"] = json_of(sheets_of(analysis.frame));
  return json;
}

}  // namespace

int run_manifolds(const ManifoldsOptions& options) {
  if (options.json) {
    Json json = {{"schema", "flatdt-manifolds 1"}, {"manifolds", Json::array()}};
    for (const CatalogueEntry& entry : catalogue()) json["manifolds"].push_back(json_of_entry(entry));
    write_output("-", json.dump(1) + "\n");
    return 0;
  }
  std::string text = overview();
  text +=
      "\ndelta^2 and sheets at the canonical metric. Sheets: Theorem 10, one copy at a time, complete "
      "orbits.\n"
      "cm(q,k) is the least value of q on nonzero integer vectors congruent to k modulo 2.\n";
  for (const CatalogueEntry& entry : catalogue()) text += "\n" + details(entry);
  write_output("-", text);
  return 0;
}

}  // namespace flatdt::ref::cli
