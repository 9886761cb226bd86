#include "ours.hpp"

#include <sstream>
#include <stdexcept>

#include "flatdt/checker/check.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::bench {
namespace {

ref::TriangulationOptions options_for(ref::Insertion insertion) {
  ref::TriangulationOptions options;
  options.insertion = insertion;
  return options;
}

template <int D>
Done done(const ref::Instance& instance, const ref::PreparedGroup& group,
          const ref::TriangulationOptions& options) {
  auto answer = std::make_shared<const ref::FrameTriangulation<D>>(
      ref::triangulate_in_frame<D>(instance.points, group, options));
  const std::size_t cells = answer->cells.size();
  return {std::move(answer), cells};
}

Done done(const ref::Instance& instance, const ref::PreparedGroup& group,
          const ref::TriangulationOptions& options = {}) {
  return instance.dimension == 2 ? done<2>(instance, group, options) : done<3>(instance, group, options);
}

}  // namespace

Work our_triangulation(ref::Instance instance, ref::Insertion insertion) {
  const auto group = std::make_shared<const ref::PreparedGroup>(ref::analyse(instance));
  const auto input = std::make_shared<const ref::Instance>(std::move(instance));
  return [input, group, options = options_for(insertion)] { return done(*input, *group, options); };
}

Work our_triangulations(std::vector<ref::Instance> instances, bool analysed_each_time) {
  const auto group = std::make_shared<const ref::PreparedGroup>(ref::analyse(instances.front()));
  const auto input = std::make_shared<const std::vector<ref::Instance>>(std::move(instances));
  return [input, group, analysed_each_time] {
    Done last;
    for (const ref::Instance& instance : *input)
      last = analysed_each_time ? done(instance, ref::PreparedGroup(ref::analyse(instance)))
                                : done(instance, *group);
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
