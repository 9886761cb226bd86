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
    for (const auto& [key, value] : verdict[name].witness)
      text.append(" ").append(key).append("=").append(value);
    text += '\n';
  }
  text += "s ";
  text += to_string(verdict.outcome);
  return text + '\n';
}

namespace {

using Json = nlohmann::ordered_json;

Json object_of(const Verdict& verdict) {
  Json conditions = Json::array();
  for (std::size_t i = 0; i < kConditionCount; ++i) {
    const auto name = static_cast<ConditionName>(i);
    Json witness = Json::object();
    for (const auto& [key, value] : verdict[name].witness) witness[key] = value;
    conditions.push_back(
        {{"name", to_string(name)}, {"status", to_string(verdict[name].status)}, {"witness", witness}});
  }
  return {{"schema", "flatdt-check 1"}, {"verdict", to_string(verdict.outcome)}, {"conditions", conditions}};
}

/// Whatever bytes a reason may quote.
std::string line_of(const Json& object) {
  return object.dump(-1, ' ', true, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string json_report(const Verdict& verdict) {
  return line_of(object_of(verdict));
}

std::string service_report(const Verdict& verdict, const std::string& id) {
  Json object = object_of(verdict);
  object["id"] = id;
  if (!verdict.reason.empty()) object["reason"] = verdict.reason;
  return line_of(object);
}

std::string service_error(const std::string& id, const std::string& error) {
  return line_of({{"schema", "flatdt-serve 1"}, {"id", id}, {"error", error}});
}

}  // namespace flatdt::checker
