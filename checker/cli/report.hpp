// The forms in which a verdict is printed.   Source: FORMAT.md, "Programs"; docs/serve.md.
#pragma once

#include <string>

#include "flatdt/checker/verdict.hpp"

namespace flatdt::checker {

/// Lines "c condition NAME STATUS key=value ..." and last "s VERDICT".
[[nodiscard]] std::string text_report(const Verdict& verdict);
/// One JSON object with the schema "flatdt-check 1", and a line feed.
[[nodiscard]] std::string json_report(const Verdict& verdict);

/// The object of json_report() with two more members: "id" and, where there is one, "reason".
[[nodiscard]] std::string service_report(const Verdict& verdict, const std::string& id);
/// One JSON object with the schema "flatdt-serve 1", and a line feed. id: "" if none could be read.
[[nodiscard]] std::string service_error(const std::string& id, const std::string& error);

}  // namespace flatdt::checker
