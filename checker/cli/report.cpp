#include "report.hpp"

#include <nlohmann/json.hpp>

namespace flatdt::checker {

std::string text_report(const Verdict& verdict) {
  std::string text;
  for (std::size_t i = 0; i < kConditionCount; ++i) {
    const auto name = static_cast<ConditionName>(i);
    text += "c condition ";
    text += to_string(name);
    text += ' ';
    text += to_string(verdict[name].status);
    for (const auto& [key, value] : verdict[name].witness) text += " " + key + "=" + value;
    text += '\n';
  }
  text += "s ";
  text += to_string(verdict.outcome);
  return text + '\n';
}

std::string json_report(const Verdict& verdict) {
  nlohmann::ordered_json conditions = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < kConditionCount; ++i) {
    const auto name = static_cast<ConditionName>(i);
    nlohmann::ordered_json witness = nlohmann::ordered_json::object();
    for (const auto& [key, value] : verdict[name].witness) witness[key] = value;
    conditions.push_back(
        {{"name", to_string(name)}, {"status", to_string(verdict[name].status)}, {"witness", witness}});
  }
  const nlohmann::ordered_json report = {
      {"schema", "flatdt-check 1"}, {"verdict", to_string(verdict.outcome)}, {"conditions", conditions}};
  return report.dump() + '\n';
}

}  // namespace flatdt::checker
