// A limit on processor time that ends the process with last words.
#pragma once

#include <string>

namespace flatdt::checker {

/// From construction to lift(): when the process has used so many seconds of processor time, `last_words` are
/// written to standard output and the process ends with exit code 3 (UNKNOWN). 0: no limit.
/// Requires: one at a time; nothing else writes to standard output meanwhile.
class TimeLimit {
 public:
  TimeLimit(unsigned seconds, const std::string& last_words);
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
  ~TimeLimit();
  void lift() const;
};

}  // namespace flatdt::checker
