#include "judge.hpp"

#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "edge_claim.hpp"
#include "flatdt/checker/check.hpp"
#include "flatdt/checker/errors.hpp"

namespace flatdt::campaign {
namespace {

constexpr const char* kOutputName = "output";

std::string verdict_object(const checker::Verdict& verdict) {
  nlohmann::ordered_json conditions = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < checker::kConditionCount; ++i) {
    const auto name = static_cast<checker::ConditionName>(i);
    nlohmann::ordered_json witness = nlohmann::ordered_json::object();
    for (const auto& [key, value] : verdict[name].witness) witness[key] = value;
    conditions.push_back({{"name", checker::to_string(name)},
                          {"status", checker::to_string(verdict[name].status)},
                          {"witness", witness}});
  }
  return nlohmann::ordered_json{{"schema", "flatdt-check 1"},
                                {"verdict", checker::to_string(verdict.outcome)},
                                {"conditions", conditions}}
             .dump(1) +
         '\n';
}

std::string failing_conditions(const checker::Verdict& verdict) {
  std::string names;
  for (std::size_t i = 0; i < checker::kConditionCount; ++i) {
    const auto name = static_cast<checker::ConditionName>(i);
    if (verdict[name].status == checker::Status::fails) names += " " + std::string(checker::to_string(name));
  }
  return names;
}

Judgement judge_triangulation(const std::string& instance_text, const std::string& output) {
  checker::Instance instance;
  try {
    std::istringstream in(instance_text);
    instance = checker::parse_instance(in, "instance");
  } catch (const checker::MalformedInput& error) {
    throw std::logic_error(std::string("the campaign made an instance that is refused: ") + error.what());
  }
  Judgement judgement;
  checker::Verdict verdict;
  try {
    std::istringstream in(output);
    const checker::Triangulation triangulation = checker::parse_triangulation(in, kOutputName, instance);
    verdict = checker::check(instance, triangulation);
  } catch (const checker::MalformedInput& error) {
    verdict.outcome = checker::Outcome::malformed;
    judgement = {Worth::wrong, "malformed", verdict_object(verdict), error.what()};
    return judgement;
  }
  judgement.verdict = verdict_object(verdict);
  judgement.reason = verdict.reason;
  switch (verdict.outcome) {
    case checker::Outcome::verified:
      return judgement;
    case checker::Outcome::refuted:
      judgement.signature = "refuted" + failing_conditions(verdict);
      break;
    case checker::Outcome::malformed:
      throw std::logic_error("the campaign made an instance that is refused: " + verdict.reason);
    case checker::Outcome::unknown:
      judgement.signature = "unknown";
      break;
  }
  judgement.worth = Worth::wrong;
  return judgement;
}

Judgement without_output(const Answer& answer) {
  const std::string code = std::to_string(answer.code);
  Judgement judgement{Worth::wrong, {}, {}, answer.errors};
  switch (answer.kind) {
    case AnswerKind::output:
      judgement.signature = "no output";
      break;
    case AnswerKind::unsupported:
      judgement.worth = Worth::unsupported;
      break;
    case AnswerKind::exit_status:
      judgement.signature = "exit status " + code;
      break;
    case AnswerKind::signal:
      judgement.signature = "signal " + signal_name(answer.code);
      break;
    case AnswerKind::timed_out:
      judgement.signature = "time limit";
      break;
    case AnswerKind::stalled:
      judgement.signature = "wall limit";
      break;
    case AnswerKind::out_of_memory:
      judgement.signature = "memory limit";
      break;
    case AnswerKind::flooded:
      judgement.signature = "output limit";
      break;
  }
  return judgement;
}

}  // namespace

Judgement judge(const std::string& instance, const Answer& answer, const Capabilities& capabilities) {
  if (answer.kind != AnswerKind::output || answer.text.empty()) return without_output(answer);
  return capabilities.claim == Claim::edges
             ? judge_edges(instance, answer.text, capabilities.facet_resolution)
             : judge_triangulation(instance, answer.text);
}

}  // namespace flatdt::campaign
