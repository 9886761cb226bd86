/// What a piece of work costs this process.
#pragma once

#include <sys/resource.h>

#include <chrono>
#include <ctime>

namespace flatdt::bench {

/// Seconds. `user` is what ratios are made of; `cpu` has the system's share as well (page faults).
struct Cost {
  double user = 0;
  double cpu = 0;
  double wall = 0;
};

/// Counts from its construction, all threads of the process together.
class Stopwatch {
 public:
  Stopwatch() : start_(now()) {}
  [[nodiscard]] Cost elapsed() const {
    const Cost end = now();
    return {end.user - start_.user, end.cpu - start_.cpu, end.wall - start_.wall};
  }

 private:
  static Cost now() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    timespec cpu{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
    return {static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec),
            static_cast<double>(cpu.tv_sec) + 1e-9 * static_cast<double>(cpu.tv_nsec),
            std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count()};
  }
  Cost start_;
};

}  // namespace flatdt::bench
