#include "child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <system_error>

#include "descriptor.hpp"

namespace flatdt::campaign {
namespace {

constexpr int kLookMilliseconds = 20;

double seconds(const timespec& t) {
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall_clock() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return seconds(t);
}

/// CPU time of a process, 0 if it cannot be read.
double cpu_clock(pid_t pid) {
  clockid_t clock{};
  timespec t{};
  if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &t) != 0) return 0;
  return seconds(t);
}

std::uint64_t resident_bytes(pid_t pid) {
  std::FILE* file = std::fopen(("/proc/" + std::to_string(pid) + "/statm").c_str(), "re");
  if (file == nullptr) return 0;
  unsigned long size = 0, resident = 0;
  const int read = std::fscanf(file, "%lu %lu", &size, &resident);
  std::fclose(file);
  return read == 2 ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void set_limit(int resource, std::uint64_t value) {
  const rlimit limit{value, value};
  setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

/// Between fork and exec: only calls that are safe in the child of a program with threads.
[[noreturn]] void become(char* const* argv, int in, int out, int err, int report, const Limits& limits) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGXFSZ, SIG_DFL);
  set_limit(RLIMIT_CORE, 0);
  if (limits.output_bytes != 0) set_limit(RLIMIT_FSIZE, limits.output_bytes);
  if (limits.address_bytes != 0) set_limit(RLIMIT_AS, limits.address_bytes);
  if (dup2(in, 0) >= 0 && dup2(out, 1) >= 0 && dup2(err, 2) >= 0) execvp(argv[0], argv);
  const int reason = errno;
  [[maybe_unused]] const ssize_t written = write(report, &reason, sizeof reason);
  _exit(127);
}

}  // namespace

Child::Child(const std::vector<std::string>& argv, int in, int out, int err, const Limits& limits)
    : limits_(limits) {
  std::vector<std::string> words = argv;
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  Pipe report;
  pid_ = fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (pid_ == 0) become(pointers.data(), in, out, err, report.write_end.get(), limits);
  setpgid(pid_, pid_);  // whoever comes first: the group must exist before it is killed
  report.write_end.close();
  int reason = 0;
  ssize_t got = 0;
  do got = read(report.read_end.get(), &reason, sizeof reason);
  while (got < 0 && errno == EINTR);
  if (got == sizeof reason) {
    waitpid(pid_, nullptr, 0);
    ended_ = true;
    throw std::system_error(reason, std::generic_category(), "cannot run " + argv.front());
  }
  end_descriptor_ = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
  if (end_descriptor_ < 0) {
    const int why = errno;
    kill(Ending::signalled);
    throw std::system_error(why, std::generic_category(), "pidfd_open");
  }
  start_clock();
}

Child::~Child() {
  if (!ended_) kill(Ending::signalled);
  if (end_descriptor_ >= 0) close(end_descriptor_);
}

void Child::start_clock() {
  wall_start_ = wall_clock();
  cpu_start_ = cpu_clock(pid_);
}

Ending Child::broken_limit() const {
  if (limits_.wall_seconds > 0 && wall_clock() - wall_start_ > limits_.wall_seconds) return Ending::stalled;
  if (limits_.cpu_seconds > 0 && cpu_clock(pid_) - cpu_start_ > limits_.cpu_seconds) return Ending::timed_out;
  if (limits_.memory_bytes > 0 && resident_bytes(pid_) > limits_.memory_bytes) return Ending::out_of_memory;
  return Ending::exited;
}

End Child::wait() {
  pollfd event{end_descriptor_, POLLIN, 0};
  while (poll(&event, 1, kLookMilliseconds) <= 0) {
    const Ending broken = broken_limit();
    if (broken != Ending::exited) return kill(broken);
  }
  return reap(Ending::exited);
}

End Child::kill(Ending why) {
  if (ended_) return end_;
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);
  return reap(why);
}

End Child::reap(Ending why) {
  // Until it is reaped its number, and so the group's, is nobody else's.
  ::kill(-pid_, SIGKILL);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  ended_ = true;
  const bool by_signal = WIFSIGNALED(status);
  end_.code = by_signal ? WTERMSIG(status) : WEXITSTATUS(status);
  end_.ending = by_signal ? Ending::signalled : Ending::exited;
  if (by_signal && end_.code == SIGXFSZ) end_.ending = Ending::flooded;
  if (by_signal && end_.code == SIGKILL && why != Ending::exited) end_.ending = why;
  return end_;
}

End run_child(const std::vector<std::string>& argv, const std::string& in, const std::string& out,
              const std::string& err, const Limits& limits) {
  const auto path = [](const std::string& name) { return name.empty() ? std::string("/dev/null") : name; };
  const Descriptor input = open_file(path(in), O_RDONLY);
  const Descriptor output = open_file(path(out), O_WRONLY | O_CREAT | O_TRUNC);
  const Descriptor errors = open_file(path(err), O_WRONLY | O_CREAT | O_TRUNC);
  return Child(argv, input.get(), output.get(), errors.get(), limits).wait();
}

std::string signal_name(int signal) {
  const char* name = sigabbrev_np(signal);
  return name != nullptr ? std::string("SIG") + name : "signal " + std::to_string(signal);
}

}  // namespace flatdt::campaign
