/// The checker's answer as one readable text, for the failure messages of any test framework.
#pragma once

#include <string>

#include "flatdt/checker/verdict.hpp"
#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/triangulation_format.hpp"
#include "flatdt/testing/specimen.hpp"

namespace flatdt::testing {

/// The text of an instance file, given as such or made of an instance or a specimen.
class InstanceText {
 public:
  InstanceText(std::string text);      // NOLINT(google-explicit-constructor): any of these is an instance
  InstanceText(const char* text);      // NOLINT(google-explicit-constructor)
  InstanceText(const ref::Instance&);  // NOLINT(google-explicit-constructor)
  InstanceText(const Specimen&);       // NOLINT(google-explicit-constructor)
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The text of a triangulation file, given as such or made of a triangulation.
class TriangulationText {
 public:
  TriangulationText(std::string text);           // NOLINT(google-explicit-constructor)
  TriangulationText(const char* text);           // NOLINT(google-explicit-constructor)
  TriangulationText(const ref::Triangulation&);  // NOLINT(google-explicit-constructor)
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// What flatdt-check says of the two files.
[[nodiscard]] checker::Verdict judge(const InstanceText& instance, const TriangulationText& triangulation);

/// Empty for VERIFIED. Otherwise the verdict, its reason if it has one, and a line for each condition that
/// fails, with its witness: "REFUTED\n  delaunay.empty fails: apex=(1,1) insphere=2".
[[nodiscard]] std::string explain(const checker::Verdict& verdict);
[[nodiscard]] std::string explain(const InstanceText& instance, const TriangulationText& triangulation);

}  // namespace flatdt::testing
