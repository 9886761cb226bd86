/// A child process in a process group of its own, with limits.
/// Laws: when a Child is destroyed or has ended, no process of its group is left; file descriptors of the
/// parent are not inherited; children die with the thread that started them.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace flatdt::campaign {

/// 0: no limit.
struct Limits {
  double cpu_seconds = 10;
  double wall_seconds = 60;
  std::uint64_t memory_bytes = std::uint64_t{2}
                               << 30;  // resident, of the child itself; looked at every 20 ms
  std::uint64_t address_bytes = std::uint64_t{8} << 30;  // of address space: RLIMIT_AS
  std::uint64_t output_bytes = std::uint64_t{64} << 20;  // of each file that is written
};

/// Of the limits on time timed_out is that of processor time, stalled that by the clock.
enum class Ending : std::uint8_t { exited, signalled, timed_out, stalled, out_of_memory, flooded };

struct End {
  Ending ending = Ending::exited;
  int code = 0;  // exit status or signal
};

class Child {
 public:
  /// Starts argv[0], looked for in PATH. The three descriptors become its standard streams.
  /// Errors: std::system_error if it cannot be started.
  Child(const std::vector<std::string>& argv, int in, int out, int err, const Limits& limits);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Waits until the child has ended, or until it breaks a limit and is killed.
  End wait();
  /// Kills the group. The end is what `why` says, unless the child had ended before.
  End kill(Ending why);

  /// Starts the clocks for wall and CPU time anew.
  void start_clock();
  /// The limit that the child breaks now, if any; exited if none.
  [[nodiscard]] Ending broken_limit() const;
  /// A descriptor that becomes readable when the child ends.
  [[nodiscard]] int end_descriptor() const { return end_descriptor_; }

 private:
  End reap(Ending why);

  pid_t pid_ = -1;
  int end_descriptor_ = -1;
  bool ended_ = false;
  End end_;
  Limits limits_;
  double wall_start_ = 0;
  double cpu_start_ = 0;
};

/// Runs a command to its end, its streams connected to files (an empty path: /dev/null).
/// Errors: std::system_error if it cannot be started or a file cannot be opened.
End run_child(const std::vector<std::string>& argv, const std::string& in, const std::string& out,
              const std::string& err, const Limits& limits);

/// "SIGSEGV" and the like.
[[nodiscard]] std::string signal_name(int signal);

}  // namespace flatdt::campaign
