// The C interface: checking, and the report.
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "../cli/report.hpp"
#include "c_objects.hpp"
#include "flatdt/checker/check_texts.hpp"

namespace checker = flatdt::checker;

struct flatdt_report {
  checker::Verdict verdict;
  std::string json;
};

namespace {

std::unique_ptr<flatdt_report> make_report(std::string_view instance, std::string_view triangulation) {
  auto report = std::make_unique<flatdt_report>();
  report->verdict = checker::check_texts(instance, triangulation);
  report->json = checker::json_report(report->verdict);
  report->json.pop_back();  // the line feed
  return report;
}

/// An entry of a witness, or nothing where there is none.
const std::pair<std::string, std::string>* entry_of(const flatdt_report* report, std::size_t condition,
                                                    std::size_t entry) {
  if (entry >= flatdt_report_witness_size(report, condition)) return nullptr;
  return &report->verdict.conditions[condition].witness[entry];
}

}  // namespace

extern "C" {

const char* flatdt_checker_version(void) {
  return FLATDT_VERSION;
}

const char* flatdt_error_text(int error) {
  switch (error) {
    case FLATDT_OK:
      return "no error";
    case FLATDT_INVALID_ARGUMENT:
      return "invalid argument: a NULL, a count that does not fit the dimension, a string that is no token, "
             "or objects of different dimensions";
    case FLATDT_OUT_OF_MEMORY:
      return "out of memory";
    case FLATDT_INTERNAL_ERROR:
      return "internal error: a defect of the library";
  }
  return "not a code of this library";
}

flatdt_error flatdt_check_texts(const char* instance, size_t instance_size, const char* triangulation,
                                size_t triangulation_size, flatdt_report** report) {
  return checker::give(report, [&] {
    const auto first = checker::span_of(instance, instance_size);
    const auto second = checker::span_of(triangulation, triangulation_size);
    return make_report({first.data(), first.size()}, {second.data(), second.size()});
  });
}

flatdt_error flatdt_check(const flatdt_instance* instance, const flatdt_triangulation* triangulation,
                          flatdt_report** report) {
  return checker::give(report, [&] {
    if (instance == nullptr || triangulation == nullptr) throw checker::RefusedPiece("a NULL object");
    // The text of a triangulation does not say its dimension, and without elements and cells nothing shows
    // it.
    if (instance->builder.dimension() != triangulation->builder.dimension())
      throw checker::RefusedPiece("objects of different dimensions");
    return make_report(instance->builder.text(), triangulation->builder.text());
  });
}

flatdt_outcome flatdt_report_outcome(const flatdt_report* report) {
  if (report == nullptr) return FLATDT_UNKNOWN;
  switch (report->verdict.outcome) {
    case checker::Outcome::verified:
      return FLATDT_VERIFIED;
    case checker::Outcome::refuted:
      return FLATDT_REFUTED;
    case checker::Outcome::malformed:
      return FLATDT_MALFORMED;
    case checker::Outcome::unknown:
      break;
  }
  return FLATDT_UNKNOWN;
}

const char* flatdt_report_reason(const flatdt_report* report) {
  return report == nullptr ? "" : report->verdict.reason.c_str();
}

const char* flatdt_report_json(const flatdt_report* report) {
  return report == nullptr ? nullptr : report->json.c_str();
}

void flatdt_report_free(flatdt_report* report) {
  delete report;
}

size_t flatdt_condition_count(void) {
  return checker::kConditionCount;
}

const char* flatdt_condition_name(size_t condition) {
  if (condition >= checker::kConditionCount) return nullptr;
  return to_string(static_cast<checker::ConditionName>(condition)).data();  // literals: they end with a zero
}

flatdt_status flatdt_report_status(const flatdt_report* report, size_t condition) {
  if (report == nullptr || condition >= checker::kConditionCount) return FLATDT_NO_CONDITION;
  switch (report->verdict.conditions[condition].status) {
    case checker::Status::holds:
      return FLATDT_HOLDS;
    case checker::Status::fails:
      return FLATDT_FAILS;
    case checker::Status::skipped:
      break;
  }
  return FLATDT_SKIPPED;
}

size_t flatdt_report_witness_size(const flatdt_report* report, size_t condition) {
  if (report == nullptr || condition >= checker::kConditionCount) return 0;
  return report->verdict.conditions[condition].witness.size();
}

const char* flatdt_report_witness_key(const flatdt_report* report, size_t condition, size_t entry) {
  const auto* const pair = entry_of(report, condition, entry);
  return pair == nullptr ? nullptr : pair->first.c_str();
}

const char* flatdt_report_witness_value(const flatdt_report* report, size_t condition, size_t entry) {
  const auto* const pair = entry_of(report, condition, entry);
  return pair == nullptr ? nullptr : pair->second.c_str();
}

}  // extern "C"
