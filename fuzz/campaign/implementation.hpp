/// The implementation under test, as something that answers instances; whatever it does, the campaign goes
/// on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "child_process.hpp"

namespace flatdt::campaign {

enum class AnswerKind : std::uint8_t {
  output,         // it says it is done; `text` is what it wrote
  unsupported,    // it says that it does not support this instance
  exit_status,    // it ended with another exit status
  signal,         // it was ended by a signal
  timed_out,      // it took too much processor time
  stalled,        // it took too long by the clock
  out_of_memory,  // it took too much memory
  flooded,        // it wrote too much
};

struct Answer {
  AnswerKind kind = AnswerKind::output;
  int code = 0;  // exit status or signal
  std::string text;
  std::string errors;  // the end of what it wrote to its standard error
};

/// How it is called.
struct Contact {
  std::vector<std::string> command;
  bool persistent = false;
  int unsupported_exit = 4;
  Limits limits;
};

/// For one thread at a time.
class Implementation {
 public:
  virtual ~Implementation() = default;
  /// Errors: std::system_error if it cannot be started at all.
  virtual Answer answer(const std::string& instance) = 0;
};

/// Starts the command for each instance. Files are kept in `folder`, which must exist. Without {instance} it
/// reads the instance on its standard input, without {output} it writes to its standard output.
std::unique_ptr<Implementation> make_one_shot(const Contact& contact, const std::string& folder);

/// Starts the command once, and again after every failure. To its standard input goes each instance, followed
/// by a line `end`; it answers with the lines of a triangulation, or with one line `unsupported REASON` or
/// `failed REASON`, and in each case a line `end`. Source: docs/campaigns.md, "Persistent mode".
std::unique_ptr<Implementation> make_persistent(const Contact& contact, const std::string& folder);

inline std::unique_ptr<Implementation> make_implementation(const Contact& contact,
                                                           const std::string& folder) {
  return contact.persistent ? make_persistent(contact, folder) : make_one_shot(contact, folder);
}

}  // namespace flatdt::campaign
