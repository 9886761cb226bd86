#include "checked.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <random>
#include <sstream>

#include "for_all.hpp"

namespace flatdt::property_tests {
namespace {

/// The seed of continuous integration. RapidCheck mixes the test's name into it.
constexpr std::uint64_t kSeed = 20110613;

bool is_set(const std::string& params, const char* key) {
  return params.find(key) != std::string::npos;
}

/// RC_PARAMS with a seed: the fixed one, or one of the day, if none is given. RapidCheck prints what it uses.
std::string settled_params() {
  const char* given = std::getenv("RC_PARAMS");
  std::string params = given == nullptr ? "" : given;
  if (!is_set(params, "seed=")) {
    std::uint64_t seed = kSeed;
    if (std::getenv("FLATDT_FRESH_SEED") != nullptr) {
      seed = (std::uint64_t{std::random_device{}()} << 32) | std::random_device{}();
      std::cout << "seed of the day: RC_PARAMS=\"seed=" << seed << "\"\n";
    }
    params += " seed=" + std::to_string(seed);
    ::setenv("RC_PARAMS", params.c_str(), 1);
  }
  return params;
}

rc::detail::TestParams parameters(int cases) {
  static const std::string settled = settled_params();
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  if (!is_set(settled, "max_success=")) params.maxSuccess = cases * effort();
  return params;
}

}  // namespace

std::string test_name() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::string(info->test_suite_name()) + "." + info->name();
}

int effort() {
  const char* text = std::getenv("FLATDT_EFFORT");
  return text == nullptr ? 1 : std::max(1, std::atoi(text));
}

bool has_fixed_seed() {
  return rc::detail::configuration().testParams.seed == kSeed;
}

int check_property(int cases, const std::function<void()>& property,
                   const std::function<std::string()>& epilogue) {
  const std::clock_t start = std::clock();
  const std::string name = test_name();
  const auto result =
      rc::detail::checkTestable(property, rc::detail::TestMetadata{name, name}, parameters(cases));
  if (result.is<rc::detail::SuccessResult>()) {
    const int done = result.get<rc::detail::SuccessResult>().numSuccess;
    std::cout << name << ": " << done << " cases, "
              << static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC << " s\n";
    ::testing::Test::RecordProperty("cases", done);
    return done;
  }
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  ADD_FAILURE() << message.str() << "\n" << (epilogue ? epilogue() : "");
  return 0;
}

}  // namespace flatdt::property_tests
