// Options as text: the line that a resumed campaign must have in common with the one before.
#include <nlohmann/json.hpp>

#include "command_template.hpp"
#include "options.hpp"

namespace flatdt::campaign {

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
        {"claims", c.claim == Claim::edges ? "edges" : "triangulation"},
        {"facet_resolution", c.facet_resolution.to_string()},
        {"unsupported_exit", c.unsupported_exit}}}};
  return line.dump();
}

}  // namespace flatdt::campaign
