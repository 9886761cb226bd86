#include "flatdt/testing/explain.hpp"

#include <sstream>
#include <utility>

#include "flatdt/checker/check_texts.hpp"
#include "flatdt/ref/instance_format.hpp"

namespace flatdt::testing {

InstanceText::InstanceText(std::string text) : text_(std::move(text)) {}
InstanceText::InstanceText(const char* text) : text_(text) {}
InstanceText::InstanceText(const ref::Instance& instance) : text_(ref::write_instance(instance)) {}
InstanceText::InstanceText(const Specimen& specimen) : InstanceText(instance_of(specimen)) {}

TriangulationText::TriangulationText(std::string text) : text_(std::move(text)) {}
TriangulationText::TriangulationText(const char* text) : text_(text) {}
TriangulationText::TriangulationText(const ref::Triangulation& triangulation)
    : text_(ref::write_triangulation(triangulation, {})) {}

checker::Verdict judge(const InstanceText& instance, const TriangulationText& triangulation) {
  return checker::check_texts(instance.text(), triangulation.text());
}

std::string explain(const checker::Verdict& verdict) {
  if (verdict.outcome == checker::Outcome::verified) return "";
  std::string text(to_string(verdict.outcome));
  if (!verdict.reason.empty()) text += ": " + verdict.reason;
  for (std::size_t i = 0; i < checker::kConditionCount; ++i) {
    const auto name = static_cast<checker::ConditionName>(i);
    if (verdict[name].status != checker::Status::fails) continue;
    text.append("\n  ").append(to_string(name)).append(" fails:");
    for (const auto& [key, value] : verdict[name].witness)
      text.append(" ").append(key).append("=").append(value);
  }
  return text;
}

std::string explain(const InstanceText& instance, const TriangulationText& triangulation) {
  return explain(judge(instance, triangulation));
}

}  // namespace flatdt::testing
