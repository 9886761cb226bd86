// The program flatdt-campaign (docs/campaigns.md). Exit codes: 0 nothing found, 1 failures found, 2 wrong
// usage, 3 internal error.
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "campaign.hpp"
#include "report.hpp"
#include "text_file.hpp"

namespace {

constexpr int kFound = 1;
constexpr int kUsage = 2;
constexpr int kInternal = 3;

std::atomic<bool> interrupted = false;  // set by the handler, which has no arguments

/// The first asks the campaign to end after the cases at hand; the second ends it at once.
void interrupt(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

/// What is closed would become the number of a child's pipe or file, and messages would go into that.
void open_standard_streams() {
  int number = -1;
  do number = ::open("/dev/null", O_RDWR);
  while (0 <= number && number <= STDERR_FILENO);
  if (number >= 0) ::close(number);
}

int run(int argc, char** argv) {
  using namespace flatdt::campaign;
  const std::optional<Options> options = parse_options(argc, argv);
  if (!options) return 0;
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  std::error_code error;
  std::filesystem::create_directories(options->out, error);
  if (error) throw UsageError("cannot make the folder " + options->out + ": " + error.message());
  std::unique_ptr<Ledger> ledger;
  try {
    ledger = std::make_unique<Ledger>(options->out, describe(*options), options->resume);
  } catch (const std::runtime_error& reason) {
    throw UsageError(reason.what());
  }
  run_campaign(*options, *ledger, interrupted);
  write_text(options->out + "/junit.xml", junit_report(*options, *ledger));
  write_text(options->out + "/report.html", html_report(*options, *ledger));
  const std::string summary = text_summary(*options, *ledger);
  write_text(options->out + "/summary.txt", summary);
  std::fputs(summary.c_str(), stdout);
  return ledger->total().wrong > 0 ? kFound : 0;
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  try {
    return run(argc, argv);
  } catch (const flatdt::campaign::UsageError& error) {
    std::fprintf(stderr, "flatdt-campaign: %s\nRun with --help for usage.\n", error.what());
    return kUsage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "flatdt-campaign: %s\n", error.what());
    return kInternal;
  }
}
