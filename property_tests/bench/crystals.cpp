/// Crystals of corpora/crystals: the engine with covers against the one without.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "flatdt/ref/instance_format.hpp"
#include "ours.hpp"

namespace flatdt::bench {
namespace {

ref::Instance read_instance(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return ref::parse_instance(text.str(), path.string());
}

std::vector<std::filesystem::path> crystal_files(const std::string& corpora) {
  std::vector<std::filesystem::path> files;
  std::error_code no_folder;  // then there are no files
  for (const auto& entry : std::filesystem::directory_iterator(corpora + "/crystals", no_folder))
    if (entry.path().extension() == ".instance") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Part> crystal_parts(const std::filesystem::path& path) {
  const ref::Instance instance = read_instance(path);
  const auto n = static_cast<double>(instance.points.size());
  return {{"flatdt", n, our_triangulation(instance)},
          {"covering", n, our_triangulation(instance, ref::Insertion::covering)}};
}

}  // namespace

std::vector<Experiment> crystal_experiments(const std::string& corpora) {
  // With more points than this a run takes long enough for the clock, and a trial run would be a waste.
  constexpr std::uintmax_t kShortFile = 5000;
  std::vector<Experiment> all;
  for (const std::filesystem::path& path : crystal_files(corpora))
    all.push_back({"crystal-" + path.stem().string(), "sites of a crystal, with both engines",
                   [path](const Settings&) { return crystal_parts(path); },
                   std::filesystem::file_size(path) < kShortFile});
  return all;
}

}  // namespace flatdt::bench
