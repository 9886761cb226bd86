#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace flatdt::campaign {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kOnTerminal{500};
constexpr std::chrono::seconds kElsewhere{10};

std::string clock_text(double seconds) {
  char text[32];
  const auto s = static_cast<long>(std::clamp(seconds, 0.0, 3.6e8));
  std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
  return text;
}

}  // namespace

Progress::Progress(const Options& options, const Ledger& ledger)
    : options_(options),
      ledger_(ledger),
      terminal_(isatty(STDERR_FILENO) != 0),
      before_(ledger.total().cases()),
      start_(Clock::now()),
      next_(start_ + (terminal_ ? Clock::duration(kOnTerminal) : Clock::duration(kElsewhere))) {}

void Progress::show() {
  if (Clock::now() < next_) return;
  next_ = Clock::now() + (terminal_ ? Clock::duration(kOnTerminal) : Clock::duration(kElsewhere));
  print(false);
}

void Progress::finish() {
  print(true);
}

void Progress::print(bool last) {
  const Tally total = ledger_.total();
  const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = spent > 0 ? static_cast<double>(total.cases() - before_) / spent : 0;
  double left = options_.seconds ? *options_.seconds - spent : 1e18;
  if (options_.cases && rate > 0) {
    const std::uint64_t mine = *options_.cases / options_.shards;
    left = std::min(left, mine > total.cases() ? static_cast<double>(mine - total.cases()) / rate : 0);
  }
  std::string line = std::to_string(total.cases()) + " cases, ";
  char number[32];
  std::snprintf(number, sizeof number, "%.1f/s", rate);
  line += number;
  line +=
      ", " + std::to_string(total.wrong) + " failures, " + std::to_string(total.unsupported) + " unsupported";
  line += last ? ", " + clock_text(spent) + " in all" : left < 1e17 ? ", " + clock_text(left) + " left" : "";
  std::fprintf(stderr, terminal_ ? "\r\033[Kflatdt-campaign: %s%s" : "flatdt-campaign: %s%s", line.c_str(),
               terminal_ && !last ? "" : "\n");
  std::fflush(stderr);
}

}  // namespace flatdt::campaign
