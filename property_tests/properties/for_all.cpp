#include "for_all.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

#include "rapidcheck_generators.hpp"

namespace flatdt::property_tests {
namespace {

/// The seed of continuous integration. RapidCheck mixes the test's name into it.
constexpr std::uint64_t kSeed = 20110613;

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

bool asked_in_rc_params(const char* key) {
  const char* params = environment("RC_PARAMS");
  return params != nullptr && std::string(params).find(key) != std::string::npos;
}

rc::detail::TestParams parameters(int cases) {
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  if (!asked_in_rc_params("max_success")) params.maxSuccess = cases * effort();
  if (environment("FLATDT_FRESH_SEED") != nullptr) {
    params.seed = (std::uint64_t{std::random_device{}()} << 32) | std::random_device{}();
    std::cout << "seed of the day: RC_PARAMS=\"seed=" << params.seed << "\"\n";
  } else if (!asked_in_rc_params("seed")) {
    params.seed = kSeed;
  }
  return params;
}

std::string test_name() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::string(info->test_suite_name()) + "." + info->name();
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The property, remembering the last specimen that failed: shrinking is greedy, so that is the smallest.
class Observed {
 public:
  explicit Observed(const Property& property) : property_(&property) {}

  void operator()(const Specimen& specimen) {
    try {
      (*property_)(specimen);
    } catch (const std::exception& error) {
      std::ostringstream text;
      text << specimen;
      failing_ = text.str();
      reason_ = error.what();
      throw;
    }
  }

  /// Writes the counterexample; returns where.
  [[nodiscard]] std::string keep(const std::string& test) const {
    const char* directory = environment("FLATDT_COUNTEREXAMPLES");
    std::string name = "property-" + test + ".instance";
    std::replace(name.begin(), name.end(), '/', '-');
    const std::filesystem::path path = std::filesystem::path(directory == nullptr ? "." : directory) / name;
    std::ofstream out(path);
    out << failing_ << "# fails " << test << ": " << reason_.substr(0, reason_.find('\n')) << "\n";
    return out ? path.string() : path.string() + " (could not be written)";
  }

 private:
  const Property* property_;
  std::string failing_;
  std::string reason_;
};

void check_file(const std::filesystem::path& path, Observed& property) {
  try {
    property(testing::read_specimen(read_file(path), path.string()));
  } catch (const std::exception& error) {
    ADD_FAILURE() << path.string() << ": " << error.what();
  }
}

bool fits(const std::filesystem::path& path, const Domain& domain) {
  const Specimen s = testing::read_specimen(read_file(path), path.string());
  const auto& names = domain.manifolds;
  return std::find(names.begin(), names.end(), testing::name_of(s)) != names.end() &&
         static_cast<long>(s.points.size()) <= domain.max_points(s.dimension());
}

std::vector<std::filesystem::path> kept_counterexamples() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(FLATDT_CORPORA "/regressions")) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("property-", 0) == 0 && entry.path().extension() == ".instance")
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int effort() {
  const char* text = environment("FLATDT_EFFORT");
  return text == nullptr ? 1 : std::max(1, std::atoi(text));
}

Domain domain_of(std::vector<std::string> manifolds) {
  Domain domain;
  domain.manifolds = std::move(manifolds);
  return domain;
}
Domain plane() {
  return domain_of(testing::manifolds_of_the_plane());
}
Domain space() {
  return domain_of(testing::manifolds_of_space());
}

int for_all(const Trials& trials, const Property& property) {
  Observed observed(property);
  if (const char* file = environment("FLATDT_INSTANCE")) {
    check_file(file, observed);
    return 0;
  }
  for (const auto& file : kept_counterexamples())
    if (fits(file, trials.domain)) check_file(file, observed);

  const std::string test = test_name();
  const auto specimens = testing::specimens(trials.domain);
  const auto result =
      rc::detail::checkTestable([&] { observed(*specimens.as("specimen")); },
                                rc::detail::TestMetadata{test, test}, parameters(trials.cases));
  if (result.is<rc::detail::SuccessResult>()) {
    const int cases = result.get<rc::detail::SuccessResult>().numSuccess;
    std::cout << cases << " cases\n";
    ::testing::Test::RecordProperty("cases", cases);
    return cases;
  }
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  ADD_FAILURE() << message.str() << "\nkept as " << observed.keep(test);
  return 0;
}

}  // namespace flatdt::property_tests
