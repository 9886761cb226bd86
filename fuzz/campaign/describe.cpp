// Options as text: durations, and the line that a resumed campaign must have in common with the one before.
#include <cmath>
#include <nlohmann/json.hpp>

#include "command_template.hpp"
#include "options.hpp"

namespace flatdt::campaign {

double parse_duration(const std::string& text) {
  std::size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const std::string unit = text.substr(used);
  const double factor = unit.empty() || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
  if (used == 0 || factor == 0 || !std::isfinite(value) || value < 0)
    throw UsageError("a time is a number with s, m or h, not \"" + text + "\"");
  return value * factor;
}

std::string describe(const Options& options) {
  const Plan& plan = options.plan;
  const Capabilities& c = plan.capabilities;
  const nlohmann::ordered_json line = {
      {"schema", "flatdt-campaign 1"},
      {"seed", plan.seed},
      {"shard", std::to_string(options.shard) + "/" + std::to_string(options.shards)},
      {"command", shell_line(options.contact.command)},
      {"persistent", options.contact.persistent},
      {"manifolds", plan.manifolds},
      {"families", plan.families},
      {"points", {plan.min_points, plan.max_points}},
      {"capabilities",
       {{"manifolds", c.manifolds},
        {"metrics", c.canonical_metric_only ? "canonical" : "any"},
        {"coordinates", c.doubles_only ? "doubles" : "any"},
        {"generators", c.names_only ? "names" : "any"},
        {"distinct", c.distinct_only},
        {"min_points", c.min_points},
        {"max_points", {c.max_points_in_plane.value_or(0), c.max_points_in_space.value_or(0)}},
        {"claims", c.claim == Claim::edges ? "edges" : "triangulation"}}}};
  return line.dump();
}

}  // namespace flatdt::campaign
