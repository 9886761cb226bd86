/// RapidCheck with this project's seeds and numbers of cases (see for_all.hpp for the environment).
#pragma once

#include <rapidcheck.h>

#include <functional>
#include <string>

namespace flatdt::property_tests {

/// Suite and name of the test that is running.
std::string test_name();

/// Checks a property that draws its values itself, `cases` times FLATDT_EFFORT. Fails the current GoogleTest
/// test with the counterexample, followed by `epilogue()`. Prints and returns the number of cases, 0 if it
/// failed.
int check_property(int cases, const std::function<void()>& property,
                   const std::function<std::string()>& epilogue = {});

}  // namespace flatdt::property_tests
