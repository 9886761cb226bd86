#include "experiment.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <iostream>

#include "cost.hpp"

namespace flatdt::bench {
namespace {

struct Measured {
  Cost cost;
  std::size_t cells = 0;
};

Measured measure(const Part& part, long calls) {
  Done done;
  Measured result;
  const Stopwatch watch;
  for (long i = 0; i < calls; ++i) done = part.work();
  result.cost = watch.elapsed();
  result.cells = done.cells;
  return result;
}

/// Doubles the number of calls until they fill the least time.
long enough_calls(const Part& part) {
  constexpr long kMaxCalls = 1L << 24;
  long calls = 1;
  while (calls < kMaxCalls && measure(part, calls).cost.user < kLeastSeconds) calls *= 2;
  return calls;
}

void print(const std::string& experiment, const Part& part, int repetition, long calls,
           const Measured& measured) {
  std::printf(
      "{\"experiment\":\"%s\",\"part\":\"%s\",\"repetition\":%d,\"items\":%.0f,\"user\":%.6f,\"cpu\":%.6f,"
      "\"wall\":%.6f,\"cells\":%zu}\n",
      experiment.c_str(), part.name.c_str(), repetition, part.items * static_cast<double>(calls),
      measured.cost.user, measured.cost.cpu, measured.cost.wall, measured.cells);
  std::fflush(stdout);
}

}  // namespace

void run(const Experiment& experiment, const Settings& settings) {
  const std::vector<Part> parts = experiment.parts(settings);
  std::vector<long> calls(parts.size(), 1);
  if (experiment.is_short)
    for (std::size_t i = 0; i < parts.size(); ++i) calls[i] = enough_calls(parts[i]);

  int repetition = 0;
  // Google Benchmark drives the repetitions: one of them measures every part once, and the user time of each
  // is a counter. Its own clock would add up the parts.
  const auto round = [&](benchmark::State& state) {
    for ([[maybe_unused]] auto iteration : state) {
      double total = 0;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const std::size_t i = (k + static_cast<std::size_t>(repetition)) % parts.size();
        const Measured measured = measure(parts[i], calls[i]);
        print(experiment.name, parts[i], repetition, calls[i], measured);
        total += measured.cost.user;
        state.counters[parts[i].name + "_us/item"] =
            1e6 * measured.cost.user / (parts[i].items * static_cast<double>(calls[i]));
      }
      state.SetIterationTime(total);
    }
    ++repetition;
  };
  benchmark::ClearRegisteredBenchmarks();
  benchmark::RegisterBenchmark(experiment.name.c_str(), round)
      ->Iterations(1)
      ->Repetitions(settings.repetitions)
      ->UseManualTime()
      ->Unit(benchmark::kSecond);
  benchmark::ConsoleReporter reporter(benchmark::ConsoleReporter::OO_None);
  reporter.SetOutputStream(&std::cerr);
  reporter.SetErrorStream(&std::cerr);
  benchmark::RunSpecifiedBenchmarks(&reporter, "all");
}

}  // namespace flatdt::bench
