/// Live progress on the standard error: one line that is rewritten on a terminal, else a line from time to
/// time.
#pragma once

#include <chrono>

#include "ledger.hpp"
#include "options.hpp"

namespace flatdt::campaign {

class Progress {
 public:
  Progress(const Options& options, const Ledger& ledger);
  /// Prints if it is time to.
  void show();
  /// The last line.
  void finish();

 private:
  void print(bool last);

  const Options& options_;
  const Ledger& ledger_;
  bool terminal_;
  std::size_t before_;  // cases of the campaign that is resumed
  std::chrono::steady_clock::time_point start_, next_;
};

}  // namespace flatdt::campaign
