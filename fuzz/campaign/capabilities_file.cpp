// Capabilities files: JSON, every value of which is checked. A value that was read as something else would
// make a campaign skip what it should test, or test what it should skip.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "capabilities.hpp"

namespace flatdt::campaign {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMostBits = 62;   // a long holds 2^62
constexpr std::uint64_t kLeastExit = 1;   // 0 would make every answer "not supported"
constexpr std::uint64_t kMostExit = 255;  // what a process can exit with
constexpr std::size_t kShown = 60;        // bytes of a value in a message

[[noreturn]] void refuse(const std::string& key, const std::string& right, const Json& found) {
  std::string text = found.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > kShown) text = text.substr(0, kShown) + "...";
  throw std::runtime_error(key + " must be " + right + ", not " + text);
}

std::uint64_t whole(const std::string& key, const Json& value, std::uint64_t least, std::uint64_t most) {
  const bool fits =
      value.is_number_unsigned() && value.get<std::uint64_t>() >= least && value.get<std::uint64_t>() <= most;
  if (!fits)
    refuse(key, "a whole number from " + std::to_string(least) + " to " + std::to_string(most), value);
  return value.get<std::uint64_t>();
}

bool truth(const std::string& key, const Json& value) {
  if (!value.is_boolean()) refuse(key, "true or false", value);
  return value.get<bool>();
}

/// Is it the first of the two words that it may be?
bool choice(const std::string& key, const Json& value, const std::string& first, const std::string& second) {
  if (value != first && value != second) refuse(key, '"' + first + "\" or \"" + second + '"', value);
  return value == first;
}

std::vector<std::string> manifold_names(const std::string& key, const Json& value) {
  const bool strings = value.is_array() && !value.empty() &&
                       std::all_of(value.begin(), value.end(), [](const Json& x) { return x.is_string(); });
  if (!strings) refuse(key, "a list of one or more names of manifolds", value);
  auto names = value.get<std::vector<std::string>>();
  for (const std::string& name : names)
    if (ref::find_entry(name) == nullptr)
      refuse(key, "a list of names that `flatdt manifolds` prints", Json(name));
  return names;
}

void read_max_points(const std::string& key, const Json& value, Capabilities& result) {
  if (!value.is_object()) refuse(key, R"(numbers for the dimensions, as in {"2": 1000, "3": 200})", value);
  for (const auto& [dimension, number] : value.items()) {
    if (dimension != "2" && dimension != "3") refuse("a key of " + key, R"("2" or "3")", Json(dimension));
    auto& most = dimension == "2" ? result.max_points_in_plane : result.max_points_in_space;
    most = whole(std::string(key).append(" \"").append(dimension).append("\""), number, 1, kMostPoints);
  }
}

void read_key(const std::string& name, const Json& value, Capabilities& result) {
  const std::string key = '"' + name + '"';
  if (name == "schema") {
    if (value != "flatdt-capabilities 1") refuse(key, R"("flatdt-capabilities 1")", value);
  } else if (name == "manifolds") {
    result.manifolds = manifold_names(key, value);
  } else if (name == "metrics") {
    result.canonical_metric_only = choice(key, value, "canonical", "any");
  } else if (name == "coordinates") {
    result.doubles_only = choice(key, value, "doubles", "any");
  } else if (name == "generators") {
    result.names_only = choice(key, value, "names", "any");
  } else if (name == "distinct") {
    result.distinct_only = truth(key, value);
  } else if (name == "min_points") {
    result.min_points = whole(key, value, 1, kMostPoints);
  } else if (name == "max_points") {
    read_max_points(key, value, result);
  } else if (name == "claims") {
    result.claim = choice(key, value, "edges", "triangulation") ? Claim::edges : Claim::triangulation;
  } else if (name == "facet_resolution_bits") {
    const auto bits = static_cast<int>(whole(key, value, 0, kMostBits));
    result.facet_resolution = ref::Rational(ref::Integer(1), ref::Integer(1L << bits));
  } else if (name == "unsupported_exit") {
    result.unsupported_exit = static_cast<int>(whole(key, value, kLeastExit, kMostExit));
  } else if (name != "comment") {
    throw std::runtime_error("there is no key " + key);
  }
}

void expect_room(const char* key, const std::optional<std::size_t>& most, std::size_t least) {
  if (most && *most < least)
    refuse(key, "at least \"min_points\", which is " + std::to_string(least), Json(*most));
}

}  // namespace

Capabilities read_capabilities(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot open " + path);
  Capabilities result;
  try {
    const Json object = Json::parse(file);
    if (!object.is_object() || !object.contains("schema"))
      throw std::runtime_error(R"(the file must be an object with the "schema" "flatdt-capabilities 1")");
    for (const auto& [key, value] : object.items()) read_key(key, value, result);
    expect_room(R"("max_points" "2")", result.max_points_in_plane, result.min_points);
    expect_room(R"("max_points" "3")", result.max_points_in_space, result.min_points);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  return result;
}

}  // namespace flatdt::campaign
