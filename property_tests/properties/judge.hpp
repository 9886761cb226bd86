/// The checker's judgement of what the reference writes, through the text of both files.
#pragma once

#include <string>

#include "flatdt/checker/verdict.hpp"
#include "flatdt/ref/triangulate.hpp"

namespace flatdt::property_tests {

/// What flatdt-check would say of two files with these contents. Errors: checker::MalformedInput.
checker::Verdict judge(const std::string& instance_text, const std::string& triangulation_text);
checker::Verdict judge(const ref::Instance& instance, const ref::Triangulation& triangulation);

/// Requires VERIFIED; the violation names the conditions that do not hold.
void require_verified(const ref::Instance& instance, const ref::Triangulation& triangulation);

/// The verdict and the conditions that do not hold, in one line.
std::string summary(const checker::Verdict& verdict);

/// ref::analyse and ref::triangulate with the given options.
ref::TriangulationResult triangulate(const ref::Instance& instance,
                                     const ref::TriangulationOptions& options = {});

}  // namespace flatdt::property_tests
