/// The command line of flatdt-campaign.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "cases.hpp"
#include "implementation.hpp"
#include "minimise.hpp"

namespace flatdt::campaign {

struct Options {
  Plan plan;
  Contact contact;
  /// Names the implementation in reports: the command as it was given, or "flatdt".
  std::string against;
  std::string flatdt;  // the program, for pictures; empty: not found
  std::string out = "campaign";
  bool resume = false;
  std::optional<double> seconds;       // stop after this time
  std::optional<std::uint64_t> cases;  // stop after the cases 0, ..., cases - 1
  std::optional<std::uint64_t> only;   // this case only
  std::uint64_t shard = 1, shards = 1;
  unsigned jobs = 1;
  std::size_t minimise_each = 5;  // failures with one signature
  Budget budget;
};

/// Wrong usage: what() says what is wrong.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The options, or nothing if --help, --version or a list was asked for and has been printed.
/// Errors: UsageError.
std::optional<Options> parse_options(int argc, const char* const* argv);

/// What determines the cases and how they are answered: one line of JSON.
std::string describe(const Options& options);

}  // namespace flatdt::campaign
