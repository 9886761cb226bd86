/// `flatdt triangulate`: an instance in, a triangulation out; the story on standard error and as a JSON
/// summary.
#include "flatdt/ref/triangulate.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "group_report.hpp"
#include "text_files.hpp"

namespace flatdt::ref::cli {
namespace {

using Json = nlohmann::ordered_json;

Json reason_json(const StayedInCover& reason) {
  Json json;
  switch (reason.kind) {
    case StayedInCover::Kind::loop:
      json["kind"] = "loop";
      json["point"] = std::to_string(reason.first);
      json["element"] = reason.g.to_string();
      break;
    case StayedInCover::Kind::two_cycle:
      json["kind"] = "2-cycle";
      json["points"] = {std::to_string(reason.first), std::to_string(reason.second)};
      json["elements"] = {reason.g.to_string(), reason.h.to_string()};
      break;
    case StayedInCover::Kind::not_invariant:
      json["kind"] = "not-invariant";
      json["cell"] = reason.cell;
      json["element"] = reason.g.to_string();
      break;
  }
  return json;
}

Json summary(std::size_t points, const GroupAnalysis& analysis, const TriangulationResult& result) {
  Json json;
  json["schema"] = "flatdt-triangulate 1";
  json["manifold"] = analysis.entry->name;
  json["dimension"] = std::to_string(analysis.frame.dimension);
  json["points"] = std::to_string(points);
  json["distinct_points"] = std::to_string(result.distinct_points);
  json["sheets"] = std::to_string(result.sheets);
  json["cells"] = std::to_string(result.triangulation.cells.size());
  json["engine"] = result.working_cover ? "covering" : "without-covers";
  json["working_cover"] = nullptr;
  if (result.working_cover) {
    Json& cover = json["working_cover"];
    cover["sheets"] = std::to_string(result.working_cover->sheets);
    cover["lattice"] = Json::array();
    for (int j = 0; j < analysis.frame.dimension; ++j) {
      const Vector v = analysis.frame.basis * result.working_cover->basis.column(j);
      cover["lattice"].push_back(v.to_string());
    }
  }
  json["switched_after_points"] =
      result.switched_after ? Json(std::to_string(*result.switched_after)) : Json(nullptr);
  json["hierarchy_levels"] = std::to_string(result.hierarchy_levels);
  json["delta_squared"] = result.delta_squared.to_string();
  json["Delta_squared"] = result.empty_diameter_squared.to_string();
  json["stayed_in_cover"] = result.reason ? reason_json(*result.reason) : Json(nullptr);
  return json;
}

void tell(std::size_t points, const GroupAnalysis& analysis, const TriangulationResult& result) {
  std::string text = analysis.entry->name + ": " + std::to_string(points) + " points";
  if (result.distinct_points != points) text += " (" + std::to_string(result.distinct_points) + " distinct)";
  if (!result.working_cover)
    text += std::string("; worked without covers; the condition of Corollary 9 ") +
            (Rational(4) * result.empty_diameter_squared < result.delta_squared ? "holds" : "does not hold");
  else if (result.switched_after)
    text += "; worked in a cover of " + std::to_string(result.working_cover->sheets) +
            " sheets; switched to the manifold after " + std::to_string(*result.switched_after) + " points";
  else
    text += "; worked in a cover of " + std::to_string(result.working_cover->sheets) +
            " sheets; the condition of Corollary 9 was not met";
  text += "\ndelta^2 = " + result.delta_squared.to_string() +
          ", Delta^2 = " + result.empty_diameter_squared.to_string() + "\n";
  for (const std::string& line : describe(result)) text += line + "\n";
  text += std::to_string(result.triangulation.cells.size()) + " cells\n";
  std::fputs(text.c_str(), stderr);
}

}  // namespace

int run_triangulate(const TriangulateOptions& options) {
  const std::string file_name = options.instance == "-" ? "<stdin>" : options.instance;
  Instance instance = parse_instance(read_input(options.instance), file_name);
  const std::size_t points = instance.points.size();
  const GroupAnalysis analysis = analysed(instance, file_name);
  TriangulationOptions settings;
  settings.insertion = options.engine == "covering" ? Insertion::covering : Insertion::without_covers;
  settings.cover = options.sheets == "theorem10" ? CoverChoice::theorem10 : CoverChoice::smallest;
  settings.smallest_cover = options.smallest_cover;
  settings.order_seed = options.order_seed;
  settings.max_sheets = options.max_sheets;
  if (options.output == options.json_summary)
    throw InvalidInput("the triangulation and the summary would both go to " +
                       (options.output == "-" ? std::string("standard output") : options.output) +
                       ": give different places with -o and --json-summary");
  const TriangulationResult result = [&] {
    try {
      return triangulate(std::move(instance), PreparedGroup(analysis), settings);
    } catch (const LimitReached& limit) {
      throw LimitReached(file_name + ": " + limit.what());
    }
  }();
  std::vector<Output> outputs{{options.output, [&result](const TextSink& sink) {
                                 write_triangulation(result.triangulation, describe(result), sink);
                               }}};
  if (!options.json_summary.empty())
    outputs.push_back(
        Output::of_text(options.json_summary, summary(points, analysis, result).dump(1) + "\n"));
  write_outputs(outputs);
  if (!options.quiet) tell(points, analysis, result);
  return 0;
}

}  // namespace flatdt::ref::cli
