#include "verdict_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref::cli {
namespace {

using Json = nlohmann::ordered_json;

/// More than verdicts have. The parser keeps a value for each open bracket: 2^24 of them took 41 s and 1.2
/// GB.
constexpr int kMaxDepth = 16;

/// Brackets open at once, at most. Those in strings do not count.
int depth_of(const std::string& json) {
  int open = 0, most = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string && c == '\\') ++i;
    if (c == '"') in_string = !in_string;
    if (in_string) continue;
    if (c == '[' || c == '{') most = std::max(most, ++open);
    if (c == ']' || c == '}') --open;
  }
  return most;
}

bool is_name(const std::string& text) {
  const auto good = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '_';
  };
  return !text.empty() && text.size() <= 100 && std::all_of(text.begin(), text.end(), good);
}

class VerdictReader {
 public:
  explicit VerdictReader(std::string file_name) : file_name_(std::move(file_name)) {}

  [[nodiscard]] Verdict read(const std::string& text) const {
    if (depth_of(text) > kMaxDepth)
      fail("has more than " + std::to_string(kMaxDepth) + " brackets open at once");
    const Json object = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (object.is_discarded()) fail("is not JSON");
    if (!object.is_object()) fail("is not one JSON object");
    if (string_at(object, "schema") != "flatdt-check 1")
      fail("has not the schema \"flatdt-check 1\": write it with flatdt-check --json");
    Verdict verdict{name_at(object, "verdict"), {}};
    const auto conditions = object.find("conditions");
    if (conditions == object.end() || !conditions->is_array()) fail("has no array \"conditions\"");
    if (conditions->size() > kMaxConditions) fail("has too many conditions");
    for (const Json& condition : *conditions) {
      if (!condition.is_object()) fail("has a condition that is not an object");
      FailedCondition failed{name_at(condition, "name"), {}};
      if (string_at(condition, "status") != "fails") continue;
      if (const auto witness = condition.find("witness"); witness != condition.end() && witness->is_object())
        for (const auto& [key, value] : witness->items())
          if (value.is_string()) failed.witness.emplace_back(key, value.get<std::string>());
      verdict.failed.push_back(std::move(failed));
    }
    return verdict;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw InvalidInput(file_name_ + ": the verdict file " + reason);
  }
  [[nodiscard]] std::string string_at(const Json& object, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_string()) fail(std::string("has no text \"") + key + "\"");
    return found->get<std::string>();
  }
  [[nodiscard]] std::string name_at(const Json& object, const char* key) const {
    std::string name = string_at(object, key);
    if (!is_name(name)) fail(std::string("has a strange \"") + key + "\"");
    return name;
  }

  std::string file_name_;
};

}  // namespace

Verdict parse_verdict(const std::string& text, const std::string& file_name) {
  if (text.size() > kMaxVerdictBytes) throw LimitReached(file_name + ": a verdict of more than 2^24 bytes");
  return VerdictReader(file_name).read(text);
}

}  // namespace flatdt::ref::cli
