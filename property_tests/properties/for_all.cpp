#include "for_all.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "checked.hpp"
#include "rapidcheck_generators.hpp"

namespace flatdt::property_tests {
namespace {

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
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
    out << "# fails " << test << ": " << reason_.substr(0, reason_.find('\n')) << "\n" << failing_;
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

  const auto specimens = testing::specimens(trials.domain).as("specimen");
  return check_property(
      trials.cases, [&] { observed(*specimens); }, [&] { return "kept as " + observed.keep(test_name()); });
}

}  // namespace flatdt::property_tests
