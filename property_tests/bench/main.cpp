/// flatdt_bench: measures, and prints JSON lines; scripts/bench makes ratios and a table of them.
/// Usage: flatdt_bench list | about
///        flatdt_bench run EXPERIMENT [options]
///        flatdt_bench memory PART [options]
///        flatdt_bench instance SET DIMENSION [options]     prints the point set as an instance file
#include <benchmark/benchmark.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "experiment.hpp"
#include "flatdt/ref/instance_format.hpp"
#include "memory.hpp"
#include "peer.hpp"
#include "point_sets.hpp"

namespace flatdt::bench {
namespace {

constexpr const char* kUsage =
    "usage: flatdt_bench list | about | run EXPERIMENT | memory nothing|flatdt|cgal | instance SET "
    "DIMENSION\n"
    "options: --points N  --repetitions N  --corpora DIR  --manifold NAME  --family NAME (of `single`)\n";

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

long positive(const std::string& text) {
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 1)
    throw UsageError("not a positive number: " + text);
  return value;
}

struct CommandLine {
  std::vector<std::string> words;
  Settings settings;
};

CommandLine parsed(int argc, char** argv) {
  CommandLine line;
  Settings& settings = line.settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.rfind("--", 0) != 0) {
      line.words.push_back(word);
      continue;
    }
    if (i + 1 == argc) throw UsageError(word + " takes a value");
    const std::string value = argv[++i];
    if (word == "--points")
      settings.points = static_cast<std::size_t>(positive(value));
    else if (word == "--repetitions")
      settings.repetitions = static_cast<int>(positive(value));
    else if (word == "--corpora")
      settings.corpora = value;
    else if (word == "--manifold")
      settings.manifold = value;
    else if (word == "--family")
      settings.family = value;
    else
      throw UsageError("unknown option " + word);
  }
  return line;
}

std::vector<Experiment> all_experiments(const Settings& settings) {
  std::vector<Experiment> all;
  for (std::vector<Experiment> some :
       {batch_experiments(), small_experiments(), manifold_experiments(),
        crystal_experiments(settings.corpora), checking_experiments(), long_cell_experiments()})
    for (Experiment& experiment : some) all.push_back(std::move(experiment));
  return all;
}

void list(const Settings& settings) {
  for (const Experiment& experiment : all_experiments(settings))
    std::cout << experiment.name << ": " << experiment.description << "\n";
}

/// What the figures depend on besides the sources, as one line of JSON.
void about() {
  std::printf("{\"compiler\":\"%s\",\"flags\":\"%s\",\"peer\":\"%s\"}\n", FLATDT_BENCH_COMPILER,
              FLATDT_BENCH_FLAGS, peer_version().c_str());
}

void run_named(const std::string& name, const Settings& settings) {
  for (const Experiment& experiment : all_experiments(settings))
    if (experiment.name == name) return run(experiment, settings);
  throw UsageError("no experiment is called " + name + "; `list` lists them");
}

void obey(const CommandLine& line) {
  const std::vector<std::string>& words = line.words;
  if (words == std::vector<std::string>{"list"}) return list(line.settings);
  if (words == std::vector<std::string>{"about"}) return about();
  if (words.size() == 2 && words[0] == "run") return run_named(words[1], line.settings);
  if (words.size() == 2 && words[0] == "memory") return run_memory(words[1], line.settings);
  if (words.size() == 3 && words[0] == "instance" && (words[2] == "2" || words[2] == "3")) {
    const PointSet set = point_set(words[1], words[2] == "2" ? 2 : 3, line.settings.points);
    std::cout << ref::write_instance(torus_instance(set));
    return;
  }
  throw UsageError("what shall be measured?");
}

}  // namespace
}  // namespace flatdt::bench

int main(int argc, char** argv) {
  int nothing = 1;
  benchmark::Initialize(&nothing, argv);
  try {
    flatdt::bench::obey(flatdt::bench::parsed(argc, argv));
  } catch (const flatdt::bench::UsageError& error) {
    std::cerr << "flatdt_bench: " << error.what() << "\n" << flatdt::bench::kUsage;
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "flatdt_bench: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
