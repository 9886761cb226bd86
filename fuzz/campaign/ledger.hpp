/// The results of a campaign: kept in memory and, line by line, in results.jsonl, from which a campaign
/// resumes. Laws: a result is in the file before it is counted; a line that was cut short is dropped when the
/// file is read.
#pragma once

#include <cstdio>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "finding.hpp"

namespace flatdt::campaign {

struct Tally {
  std::size_t right = 0;
  std::size_t unsupported = 0;
  std::size_t wrong = 0;
  [[nodiscard]] std::size_t cases() const { return right + unsupported + wrong; }
};

/// For any number of threads.
class Ledger {
 public:
  /// `description` is what a resumed campaign must have in common with the one before: one line of JSON, the
  /// first of the file. Errors: std::runtime_error if the folder has results already and `resume` is not set,
  /// or if those are of another campaign; if the file cannot be written.
  Ledger(const std::string& folder, const std::string& description, bool resume);
  ~Ledger();
  Ledger(const Ledger&) = delete;
  Ledger& operator=(const Ledger&) = delete;

  /// Errors: std::runtime_error if it cannot be written.
  void add(const Result& result);
  [[nodiscard]] bool has(std::uint64_t number) const;
  /// Counts a failure of this signature; is it one of the first `most`?
  bool is_among_first(const std::string& signature, std::size_t most);

  [[nodiscard]] Tally total() const;
  /// By manifold and family.
  [[nodiscard]] std::map<std::pair<std::string, std::string>, Tally> tallies() const;
  [[nodiscard]] std::vector<Result> failures() const;
  [[nodiscard]] std::size_t resumed() const { return resumed_; }

 private:
  void count(const Result& result);
  void read(const std::string& path, const std::string& description);

  mutable std::mutex mutex_;
  std::FILE* file_ = nullptr;
  std::size_t resumed_ = 0;
  std::set<std::uint64_t> done_;
  std::map<std::string, std::size_t> seen_;
  std::map<std::pair<std::string, std::string>, Tally> tallies_;
  Tally total_;
  std::vector<Result> failures_;
};

}  // namespace flatdt::campaign
