/// Campaigns for tests: in folders of their own, with few cases.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <string>

#include "campaign.hpp"
#include "text_file.hpp"

namespace flatdt::campaign {

/// A folder that is removed in the end.
class Folder {
 public:
  Folder() {
    std::string path = (std::filesystem::temp_directory_path() / "flatdt-campaign-XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr) throw std::runtime_error("mkdtemp");
    path_ = path;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Cases on plane manifolds against the program `flawed`. No limit of address space: sanitizers reserve much.
inline Options small_campaign(const std::string& way, bool persistent, const std::string& out) {
  Options options;
  options.plan.manifolds = testing::manifolds_of_the_plane();
  options.plan.families = {"uniform", "small-grid", "clustered", "integer-grid"};
  options.plan.max_points = 20;
  options.contact.command = {FLATDT_FLAWED, way};
  options.contact.persistent = persistent;
  if (persistent)
    options.contact.command.emplace_back("--loop");
  else
    options.contact.command.insert(options.contact.command.end(), {"{instance}", "{output}"});
  options.contact.limits.address_bytes = 0;
  options.contact.limits.memory_bytes = std::uint64_t{400} << 20;
  options.contact.limits.output_bytes = std::uint64_t{1} << 20;
  options.against = way;
  options.out = out;
  options.cases = 10;
  options.minimise_each = 3;
  return options;
}

inline std::vector<Group> run(const Options& options, bool resume = false) {
  static const std::atomic<bool> kNever = false;
  Ledger ledger(options.out, describe(options), resume);
  run_campaign(options, ledger, kNever);
  return grouped(ledger.failures());
}

/// The lines of results.jsonl after the first.
inline std::vector<std::string> result_lines(const std::string& folder) {
  std::vector<std::string> lines;
  const std::string text = read_text(folder + "/results.jsonl");
  for (std::size_t at = text.find('\n') + 1; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

}  // namespace flatdt::campaign
