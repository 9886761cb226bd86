#include "ours.hpp"

#include <sstream>
#include <stdexcept>

#include "flatdt/checker/check.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::bench {
namespace {

/// An instance with the analysis of its group.
struct Prepared {
  ref::Instance instance;
  ref::GroupAnalysis analysis;
};

std::shared_ptr<const Prepared> prepared(ref::Instance instance) {
  ref::GroupAnalysis analysis = ref::analyse(instance);
  return std::make_shared<const Prepared>(Prepared{std::move(instance), std::move(analysis)});
}

Done done(ref::TriangulationResult made) {
  const std::size_t cells = made.triangulation.cells.size();
  return {std::make_shared<const ref::TriangulationResult>(std::move(made)), cells};
}

ref::TriangulationOptions options_for(ref::Insertion insertion) {
  ref::TriangulationOptions options;
  options.insertion = insertion;
  return options;
}

}  // namespace

Work our_triangulation(ref::Instance instance, ref::Insertion insertion) {
  return [input = prepared(std::move(instance)), options = options_for(insertion)] {
    return done(ref::triangulate(input->instance, input->analysis, options));
  };
}

Work our_triangulations(std::vector<ref::Instance> instances, bool analysed_each_time) {
  ref::GroupAnalysis analysis = ref::analyse(instances.front());
  struct Several {
    std::vector<ref::Instance> instances;
    ref::GroupAnalysis analysis;
  };
  const auto input = std::make_shared<const Several>(Several{std::move(instances), std::move(analysis)});
  return [input, analysed_each_time] {
    Done last;
    for (const ref::Instance& instance : input->instances) {
      ref::TriangulationResult made = analysed_each_time
                                          ? ref::triangulate(instance, ref::analyse(instance), {})
                                          : ref::triangulate(instance, input->analysis, {});
      last = done(std::move(made));
    }
    return last;
  };
}

Work our_check(const ref::Instance& instance) {
  struct Parsed {
    checker::Instance instance;
    checker::Triangulation triangulation;
  };
  std::istringstream instance_text(ref::write_instance(instance));
  checker::Instance judged = checker::parse_instance(instance_text, "instance");
  std::istringstream triangulation_text(
      ref::write_triangulation(ref::triangulate(instance, ref::analyse(instance), {}).triangulation, {}));
  checker::Triangulation claimed = checker::parse_triangulation(triangulation_text, "triangulation", judged);
  const auto input = std::make_shared<const Parsed>(Parsed{std::move(judged), std::move(claimed)});
  return [input] {
    auto verdict = std::make_shared<checker::Verdict>(checker::check(input->instance, input->triangulation));
    if (verdict->outcome != checker::Outcome::verified)
      throw std::runtime_error("our own triangulation is " + std::string(to_string(verdict->outcome)));
    return Done{std::move(verdict), input->triangulation.cells.size()};
  };
}

}  // namespace flatdt::bench
