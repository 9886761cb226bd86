// flatdt-check INSTANCE TRIANGULATION [--json] [--jobs N]: reads two files, prints the verdict. With --serve:
// serve.hpp. The exit code and the last line of standard output always say the same: 0 VERIFIED, 1 REFUTED, 2
// MALFORMED, 3 UNKNOWN; wrong usage, an unreadable file too, is 2 without a verdict.   Source: FORMAT.md,
// "Programs".
#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <system_error>
#include <thread>

#include "../bindings/judged.hpp"
#include "examples.hpp"
#include "flatdt/checker/check.hpp"
#include "imported.hpp"
#include "report.hpp"
#include "serve.hpp"

namespace flatdt::checker {
namespace {

constexpr int kUsage = 2;
constexpr int kInternal = 3;

// Fewer cells are not worth a thread, and each thread takes 8 bytes for every vertex. Both hold for the
// default only: --jobs is obeyed as it is, so that small files can show what threads do.
constexpr std::size_t kManyCells = 10'000;
constexpr unsigned kMostJobsUnasked = 8;

unsigned default_jobs(const Triangulation& triangulation) {
  if (triangulation.cells.size() < kManyCells) return 1;
  return std::clamp(std::thread::hardware_concurrency(), 1U, kMostJobsUnasked);
}

/// `jobs`: threads, or 0 for the default.
Verdict check_with(const Instance& instance, const Triangulation& triangulation, unsigned jobs) {
  return check(instance, triangulation, {.jobs = jobs == 0 ? default_jobs(triangulation) : jobs});
}

int exit_code(Outcome outcome) {
  switch (outcome) {
    case Outcome::verified:
      return 0;
    case Outcome::refuted:
      return 1;
    case Outcome::malformed:
      return 2;
    case Outcome::unknown:
      return 3;
  }
  return kInternal;
}

void complain(const std::string& message) {
  std::fprintf(stderr, "flatdt-check: %s\n", message.c_str());
}

/// Writes to standard output; `code`, if all of it arrived.
int print(const std::string& text, int code) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) == 0 && written) return code;
  complain("cannot write to standard output");
  return kInternal;
}

/// The failure with the system's reason for it.
std::ios_base::failure unreadable(const std::string& what) {
  return std::ios_base::failure(what, std::error_code(errno, std::generic_category()));
}

/// An input file, or standard input for "-". A directory opens but cannot be read, hence the peek.
class Input {
 public:
  explicit Input(const std::string& path) : name_(path == "-" ? "<stdin>" : path) {
    if (path == "-") {
      stream_ = &std::cin;
    } else {
      file_.open(path, std::ios::binary);
      if (!file_) throw unreadable("cannot open " + path);
      stream_ = &file_;
    }
    try {
      stream_->rdbuf()->sgetc();
    } catch (const std::ios_base::failure&) {
      throw unreadable("cannot read " + path);
    }
    if (path == "-" && std::ferror(stdin) != 0) throw unreadable("cannot read standard input");
  }
  [[nodiscard]] std::istream& stream() { return *stream_; }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::ifstream file_;
  std::istream* stream_ = nullptr;
};

Verdict judge(Input& instance_input, Input& triangulation_input, unsigned jobs) {
  return judged([&] {
    const Instance instance = parse_instance(instance_input.stream(), instance_input.name());
    const Triangulation triangulation =
        parse_triangulation(triangulation_input.stream(), triangulation_input.name(), instance);
    return check_with(instance, triangulation, jobs);
  });
}

Verdict judge_import(Input& input, const std::string& format, unsigned jobs) {
  return judged([&] {
    const Imported imported = import_file(input.stream(), input.name(), format);
    complain(imported.note);
    return check_with(imported.instance, imported.triangulation, jobs);
  });
}

bool json = false;  // for the handler below, which has no arguments

/// GMP would abort when memory runs out, and its callers cannot be unwound: the verdict is printed and the
/// process ends.
[[noreturn]] void out_of_memory() {
  complain("out of memory");
  std::fputs(
      json ? "{\"schema\":\"flatdt-check 1\",\"verdict\":\"UNKNOWN\",\"conditions\":[]}\n" : "s UNKNOWN\n",
      stdout);
  std::fflush(stdout);
  std::_Exit(kInternal);
}

void* allocate(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) out_of_memory();
  return memory;
}

void* reallocate(void* old, std::size_t, std::size_t size) {
  void* memory = std::realloc(old, size);
  if (memory == nullptr) out_of_memory();
  return memory;
}

void release(void* memory, std::size_t) {
  std::free(memory);
}

/// CLI11 wraps negative numbers.
std::string is_limit(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return digits && text.size() <= 9 ? ""
                                    : "a limit is a whole number of at most 9 digits, not '" + text + "'";
}

int parse_and_run(int argc, const char* const* argv) {
  json = false;
  mp_set_memory_functions(allocate, reallocate, release);
  CLI::App app(
      "Checks that a triangulation is the Delaunay triangulation of an instance's points in a flat "
      "manifold.");
  app.footer(
      "'-' is standard input, for one of the two files.\n"
      "Exit codes: 0 VERIFIED, 1 REFUTED, 2 MALFORMED or wrong usage, 3 UNKNOWN.\n" +
      std::string(kExamples));
  std::string instance_path;
  std::string triangulation_path;
  std::string format;
  app.add_option("INSTANCE", instance_path, "instance file");
  app.add_option("TRIANGULATION", triangulation_path, "triangulation file");
  app.add_option("--from", format, "INSTANCE is a file of this format, instance and triangulation in one")
      ->check(CLI::IsMember(import_formats()));
  app.add_flag("--json", json, "print one JSON object");
  ServeLimits limits;
  bool serving = false;
  app.add_flag("--serve", serving,
               "answer requests on standard input, one line of JSON each (docs/serve.md)");
  const CLI::Option* max_bytes =
      app.add_option("--max-bytes", limits.bytes, "with --serve: largest request, both texts together")
          ->check(is_limit)
          ->capture_default_str();
  const CLI::Option* max_seconds = app.add_option("--max-seconds", limits.seconds,
                                                  "with --serve: processor time for one check; 0: no limit")
                                       ->check(is_limit)
                                       ->capture_default_str();
  unsigned jobs = 0;
  app.add_option("--jobs", jobs, "threads; default: one, for large files one for each core; same output")
      ->check(CLI::Range(1U, Stages::kMostJobs));
  app.add_flag_callback(
      "--version", [] { throw CLI::Success(); }, "print the version");
  try {
    app.parse(argc, argv);
    const bool files_given = !instance_path.empty() || !triangulation_path.empty() || !format.empty();
    if (serving && jobs != 0) throw CLI::ValidationError("--serve checks with one thread: no --jobs");
    if (serving && files_given) throw CLI::ValidationError("--serve reads requests, and takes no files");
    if (!serving && max_bytes->count() + max_seconds->count() > 0)
      throw CLI::ValidationError("--max-bytes and --max-seconds belong to --serve");
    if (!format.empty() && (instance_path.empty() || !triangulation_path.empty()))
      throw CLI::ValidationError("with --from there is one file");
    if (!serving && format.empty() && (instance_path.empty() || triangulation_path.empty()))
      throw CLI::ValidationError("INSTANCE and TRIANGULATION are required");
    if (instance_path == "-" && triangulation_path == "-")
      throw CLI::ValidationError("'-' can stand for one file only");
  } catch (const CLI::CallForHelp&) {
    return print(app.help(), 0);
  } catch (const CLI::Success&) {
    return print("flatdt-check " FLATDT_VERSION "\n", 0);
  } catch (const CLI::ParseError& error) {
    complain(std::string(error.what()) + "\nRun with --help for usage.");
    return kUsage;
  }
  if (serving) {
    json = true;
    const int code = serve(std::cin, stdout, limits);
    if (code == kInternal) complain("cannot write to standard output");
    if (std::ferror(stdin) != 0) throw unreadable("cannot read standard input");
    return code;
  }
  Input instance(instance_path);
  const Verdict verdict = [&] {
    if (!format.empty()) return judge_import(instance, format, jobs);
    Input triangulation(triangulation_path);
    return judge(instance, triangulation, jobs);
  }();
  if (!verdict.reason.empty()) complain(verdict.reason);
  return print(json ? json_report(verdict) : text_report(verdict), exit_code(verdict.outcome));
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const std::ios_base::failure& error) {
    complain(error.what());
    return kUsage;
  } catch (const std::exception& error) {
    complain(error.what());
    return kInternal;
  }
}

}  // namespace flatdt::checker
