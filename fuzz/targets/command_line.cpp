/// Command lines of both programs, run in a folder of their own: the exit code is one of those documented,
/// the checker's last line says the same, and a failed run leaves no file behind.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "../../checker/cli/command_line.hpp"
#include "../../ref/cli/command_line.hpp"
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

void run(const Invocation& line, const WorkingFolder& folder) {
  write("i", line.instance);
  write("t", line.triangulation);
  std::vector<const char*> argv = {line.is_checker ? "flatdt-check" : "flatdt"};
  for (const std::string& argument : line.arguments) argv.push_back(argument.c_str());
  argv.push_back(nullptr);
  const int argc = static_cast<int>(argv.size()) - 1;
  const std::size_t files_before = folder.files();

  Redirection redirection;
  const int code = line.is_checker ? checker::run_command_line(argc, argv.data())
                                   : ref::cli::run_command_line(argc, argv.data());
  const std::string output = redirection.text();
  expect(code >= 0 && code <= 3 && (line.is_checker || code != 1), "the exit code is a documented one");
  if (line.is_checker) {
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
  std::string command = line.is_checker ? "flatdt-check" : "flatdt";
  for (const std::string& argument : line.arguments) command += " '" + argument + "'";
  return {{"command", command + " < t\n"}, {"i", line.instance}, {"t", line.triangulation}};
}

/// The arguments one a line, the first being the program; then the instance; then the triangulation.
std::optional<Bytes> encode(const std::vector<std::string>& texts) {
  if (texts.empty() || texts.size() > 3) return std::nullopt;
  Bytes bytes;
  std::string arguments = texts[0];
  bytes.push_back(arguments.rfind("flatdt-check", 0) == 0 ? 1 : 0);
  arguments.erase(0, std::min(arguments.find('\n'), arguments.size()));
  for (const char c : arguments)
    bytes.push_back(c == '\n' ? std::uint8_t{' '} : static_cast<std::uint8_t>(c));
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
