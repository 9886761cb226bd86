/// Command lines of the programs, run in a folder of their own: the exit code is one of those documented, the
/// checker's last line says the same, its service answers in lines of JSON, and a failed run leaves no file
/// behind. Of flatdt-campaign only the command line is read: it means a campaign within its limits, or is
/// refused as wrong usage.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "../../checker/cli/command_line.hpp"
#include "../../ref/cli/command_line.hpp"
#include "../campaign/options.hpp"
#include "../engine/expect.hpp"
#include "../engine/target.hpp"
#include "invocation.hpp"

namespace flatdt::fuzz {
namespace {

namespace fs = std::filesystem;

/// A folder in the fastest place there is, removed at the end; the process works in it.
class WorkingFolder {
 public:
  WorkingFolder() {
    const fs::path parent = fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path();
    std::string name = (parent / "flatdt-fuzz-XXXXXX").string();
    expect(::mkdtemp(name.data()) != nullptr, "a folder can be made in " + parent.string());
    path_ = name;
    home_ = fs::current_path();
  }
  ~WorkingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

  void enter() const { fs::current_path(path_); }
  /// Removes all files and goes back to where the process was.
  void leave() const {
    for (const auto& entry : fs::directory_iterator(path_)) fs::remove_all(entry.path());
    fs::current_path(home_);
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

 private:
  fs::path path_;
  fs::path home_;
};

void write(const char* name, const std::string& text) {
  std::ofstream out(name, std::ios::binary);
  out << text;
}

/// Standard input from the file `t`, standard output into memory, while it lives.
class Redirection {
 public:
  Redirection() : saved_input_(::dup(0)), saved_output_(::dup(1)), captured_(::memfd_create("stdout", 0)) {
    expect(captured_ >= 0 && saved_output_ >= 0, "standard output can be redirected");
    std::fflush(stdout);
    expect(std::freopen("t", "rb", stdin) != nullptr, "standard input can be redirected");
    ::dup2(captured_, 1);
    std::cin.clear();
  }
  ~Redirection() {
    restore();
    ::close(captured_);
  }
  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;

  /// What was written to standard output.
  [[nodiscard]] std::string text() {
    restore();
    std::string result(static_cast<std::size_t>(::lseek(captured_, 0, SEEK_END)), '\0');
    const ssize_t n = ::pread(captured_, result.data(), result.size(), 0);
    expect(n == static_cast<ssize_t>(result.size()), "what was captured can be read");
    return result;
  }

 private:
  void restore() {
    if (saved_output_ < 0) return;
    std::fflush(stdout);
    std::cout.flush();
    ::dup2(saved_output_, 1);
    ::close(saved_output_);
    saved_output_ = -1;
    if (saved_input_ >= 0) {
      ::dup2(saved_input_, 0);
      ::close(saved_input_);
    }
  }

  int saved_input_;
  int saved_output_;
  int captured_;
};

void expect_verdict(int code, const std::string& output, bool json) {
  static constexpr const char* kWords[] = {"VERIFIED", "REFUTED", "MALFORMED", "UNKNOWN"};
  const std::string word = kWords[code];
  if (json) {
    expect(output.empty() || output.find("\"verdict\":\"" + word + "\"") != std::string::npos,
           "the JSON verdict is that of the exit code");
    return;
  }
  const std::string line = "s " + word + "\n";
  const bool has_verdict = output.rfind("s ", 0) == 0 || output.find("\ns ") != std::string::npos;
  expect(!has_verdict || output.ends_with(line), "the last line is the verdict of the exit code");
}

/// The exit code of --serve is about the input as a whole; the verdicts are in the replies.
void expect_replies(int code, const std::string& output) {
  expect(code != 1, "the service does not end with a verdict");
  if (output.empty() || output[0] != '{') return;  // wrong usage, or help
  for (std::size_t at = 0; at < output.size();) {
    const std::size_t end = output.find('\n', at);
    expect(end != std::string::npos && output.compare(at, 17, "{\"schema\":\"flatdt") == 0 &&
               output[end - 1] == '}',
           "every reply is an object in a line of its own");
    at = end + 1;
  }
}

/// Reads a command line of flatdt-campaign; 0 or 2, as the program would end.
int read_campaign(int argc, const char* const* argv) {
  try {
    const std::optional<campaign::Options> options = campaign::parse_options(argc, argv);
    if (!options) return 0;
    const campaign::Limits& limits = options->contact.limits;
    expect(limits.cpu_seconds >= 0 && limits.wall_seconds >= 0 && options->budget.seconds >= 0 &&
               options->seconds.value_or(0) >= 0,
           "times are numbers from 0 on");
    expect(options->jobs >= 1 && options->shard >= 1 && options->shard <= options->shards,
           "there is a thread and a part of the cases");
    expect(options->contact.unsupported_exit > 0 && options->contact.unsupported_exit < 256,
           "the exit code of what is not supported is that of a failure");
    expect(!options->contact.command.empty() && !options->plan.manifolds.empty() &&
               !options->plan.families.empty(),
           "there is something to run, and to draw from");
    static_cast<void>(campaign::draw_case(options->plan, options->only.value_or(0)));
    return 0;
  } catch (const campaign::UsageError& error) {
    expect(*error.what() != '\0', "wrong usage is explained");
    return 2;
  }
}

int run_program(Program program, int argc, const char* const* argv) {
  switch (program) {
    case Program::checker:
      return checker::run_command_line(argc, argv);
    case Program::campaign:
      return read_campaign(argc, argv);
    case Program::reference:
      break;
  }
  return ref::cli::run_command_line(argc, argv);
}

void run(const Invocation& line, const WorkingFolder& folder) {
  write("i", line.instance);
  write("t", line.triangulation);
  std::vector<const char*> argv = {name_of(line.program)};
  for (const std::string& argument : line.arguments) argv.push_back(argument.c_str());
  argv.push_back(nullptr);
  const int argc = static_cast<int>(argv.size()) - 1;
  const std::size_t files_before = folder.files();

  Redirection redirection;
  const int code = run_program(line.program, argc, argv.data());
  const std::string output = redirection.text();
  const bool is_checker = line.program == Program::checker;
  expect(code >= 0 && code <= 3 && (is_checker || code != 1), "the exit code is a documented one");
  const bool serves = std::any_of(line.arguments.begin(), line.arguments.end(),
                                  [](const std::string& word) { return word.starts_with("--serve"); });
  if (is_checker && serves) {
    expect_replies(code, output);
  } else if (is_checker) {
    const bool json = output.rfind('{', 0) == 0;
    expect_verdict(code, output, json);
    expect(code != 1 || !output.empty(), "REFUTED is never said without a verdict");
  } else if (code != 0) {
    expect(folder.files() == files_before, "a failed run leaves no file behind");
  }
}

}  // namespace

std::vector<File> print(std::span<const std::uint8_t> bytes) {
  const Invocation line = invocation_of(bytes);
  std::string command = name_of(line.program);
  for (const std::string& argument : line.arguments) command += " '" + argument + "'";
  return {{"command", command + " < t\n"}, {"i", line.instance}, {"t", line.triangulation}};
}

/// The arguments one a line, the first being the program; then the instance; then the triangulation.
std::optional<Bytes> encode(const std::vector<std::string>& texts) {
  if (texts.empty() || texts.size() > 3) return std::nullopt;
  Bytes bytes;
  const std::string& arguments = texts[0];
  std::uint8_t first = 0;  // of the programs, whose names begin alike, the last that fits
  for (const std::uint8_t candidate : {0, 1, 4})
    if (arguments.starts_with(name_of(invocation_of({&candidate, 1}).program))) first = candidate;
  bytes.push_back(first);
  std::istringstream rest(arguments);
  std::string argument;
  std::getline(rest, argument);
  while (std::getline(rest, argument)) {
    const auto known = std::find(words().begin(), words().end(), argument);
    bytes.push_back(' ');
    if (known != words().end())
      bytes.push_back(static_cast<std::uint8_t>(kFirstWord + (known - words().begin())));
    else
      bytes.insert(bytes.end(), argument.begin(), argument.end());
  }
  bytes.push_back('\n');
  for (std::size_t k = 1; k < texts.size(); ++k) {
    if (k > 1) bytes.push_back(0);
    bytes.insert(bytes.end(), texts[k].begin(), texts[k].end());
  }
  return bytes;
}

}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatdt::fuzz;
  static const WorkingFolder folder;
  folder.enter();
  run(invocation_of({data, size}), folder);
  folder.leave();
  return 0;
}
