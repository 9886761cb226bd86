/// Experiments: pieces of work measured side by side, in turns, in one process.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace flatdt::bench {

/// What a piece of work made: kept until the clock has stopped, so that its destruction is not measured.
struct Done {
  std::shared_ptr<const void> held;
  /// Cells of the triangulation, for information; 0 where there is none.
  std::size_t cells = 0;
};
using Work = std::function<Done()>;

/// One of the things that are compared.
struct Part {
  std::string name;
  /// How many points, triangulations, ... one call of `work` handles.
  double items;
  Work work;
};

/// What an experiment may be asked for on the command line.
struct Settings {
  std::size_t points = 100000;
  int repetitions = 5;
  std::string corpora = "corpora";
  std::string manifold = "torocosm";
  std::string family = "uniform";
};

struct Experiment {
  std::string name;
  std::string description;
  /// Called once before the first repetition; what it does is not measured.
  std::function<std::vector<Part>(const Settings&)> parts;
  /// Short work is called as often as it takes to fill kLeastSeconds; each part finds its number of calls
  /// before the first repetition.
  bool is_short = false;
};

inline constexpr double kLeastSeconds = 0.25;

/// Runs all parts `settings.repetitions` times in turns, beginning with another part each time, and prints
/// one line of JSON for each measurement:
///   {"experiment":..,"part":..,"repetition":0,"items":..,"user":..,"cpu":..,"wall":..,"cells":..}
/// where the times are seconds for all items together.
void run(const Experiment& experiment, const Settings& settings);

/// The experiments of each file.
std::vector<Experiment> batch_experiments();
std::vector<Experiment> small_experiments();
std::vector<Experiment> manifold_experiments();
/// One for each file of corpora/crystals.
std::vector<Experiment> crystal_experiments(const std::string& corpora);
std::vector<Experiment> checking_experiments();
std::vector<Experiment> long_cell_experiments();

}  // namespace flatdt::bench
