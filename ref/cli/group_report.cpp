#include "group_report.hpp"

#include "commands.hpp"
#include "flatdt/ref/cover.hpp"
#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::cli {
namespace {

/// A cover beyond the limit is a fact about the metric to report, not a failure of the command.
template <typename MakeCover>
std::string sheets_or_limit(MakeCover make_cover) {
  try {
    return std::to_string(make_cover().sheets);
  } catch (const LimitReached& limit) {
    return std::string("limit reached: ") + limit.what();
  }
}

}  // namespace

GroupAnalysis analysed(const Instance& instance, const std::string& file_name) {
  try {
    return analyse(instance);
  } catch (const InvalidInput& error) {
    const SectionLines& lines = instance.lines;
    // A group without a section of its own comes from the name, a metric without one from the generators or
    // the name.
    const int group = lines.generators != 0 ? lines.generators : lines.manifold;
    int line = group;
    if (error.section() == InvalidInput::Section::manifold) line = lines.manifold;
    if (error.section() == InvalidInput::Section::metric && lines.metric != 0) line = lines.metric;
    throw InvalidInput(file_name + ":" + std::to_string(line) + ": " + error.what(), error.section());
  } catch (const LimitReached& limit) {
    throw LimitReached(file_name + ": " + limit.what());
  }
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

std::string homology_text(const Homology& h1) {
  std::vector<std::string> summands;
  if (h1.betti == 1) summands.emplace_back("Z");
  if (h1.betti > 1) summands.push_back("Z^" + std::to_string(h1.betti));
  for (const long order : h1.torsion) summands.push_back("Z" + std::to_string(order));
  return summands.empty() ? "0" : joined(summands, " + ");
}

Json json_of(const Vector& v) {
  Json entries = Json::array();
  for (int i = 0; i < v.dimension(); ++i) entries.push_back(v[i].to_string());
  return entries;
}

Json json_of(const Matrix& m) {
  Json rows = Json::array();
  for (int i = 0; i < m.dimension(); ++i) {
    Json row = Json::array();
    for (int j = 0; j < m.dimension(); ++j) row.push_back(m(i, j).to_string());
    rows.push_back(row);
  }
  return rows;
}

Json json_of(const Isometry& g) {
  Json rows = json_of(g.linear);
  for (int i = 0; i < g.dimension(); ++i)
    rows[static_cast<std::size_t>(i)].push_back(g.translation[i].to_string());
  return rows;
}

Json json_of(const std::vector<Isometry>& elements) {
  Json list = Json::array();
  for (const Isometry& g : elements) list.push_back(json_of(g));
  return list;
}

Json json_of(const Homology& h1) {
  Json torsion = Json::array();
  for (const long order : h1.torsion) torsion.push_back(order);
  return {{"betti", h1.betti}, {"torsion", torsion}};
}

Json json_of_names(const CatalogueEntry& entry) {
  Json json;
  json["name"] = entry.name;
  json["aliases"] = entry.aliases;
  json["dimension"] = entry.dimension;
  json["space_groups"] = entry.space_groups;
  json["orientable"] = entry.orientable;
  json["holonomy"] = {{"name", entry.holonomy}, {"order", entry.holonomy_order}};
  json["h1"] = json_of(entry.h1);
  return json;
}

Sheets sheets_of(const Frame& frame) {
  const long max_sheets = TriangulateOptions{}.max_sheets;
  return {sheets_or_limit([&] { return theorem10_cover(frame, max_sheets); }),
          sheets_or_limit([&] { return one_at_a_time_cover(frame, max_sheets); }),
          sheets_or_limit([&] { return complete_orbit_cover(frame); })};
}

Json json_of(const Sheets& sheets) {
  return {{"theorem10", sheets.theorem10},
          {"one_at_a_time", sheets.one_at_a_time},
          {"complete_orbits", sheets.complete_orbits}};
}

}  // namespace flatdt::ref::cli
