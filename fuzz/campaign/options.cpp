#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <sstream>
#include <thread>

#include "command_template.hpp"
#include "numbers.hpp"

namespace flatdt::campaign {
namespace {

constexpr double kDefaultSeconds = 60;
constexpr const char* kFooter =
    "Examples:\n"
    "  flatdt-campaign --manifold torus,didicosm --points 1..4 --cases 10 --out first\n"
    "  flatdt-campaign --against 'flatdt triangulate -q {instance} -o {output}' --manifold klein-bottle \\\n"
    "    --points 1..20 --time 1m --cases 20 --seed 7 --jobs 2 --out second\n"
    "  flatdt-campaign --against 'flatdt triangulate -q -' --family grid,lattice --points 1..6 --cases 5 \\\n"
    "    --out third\n"
    "Without --against the campaign tests flatdt. Results, reports and minimised failures are written to "
    "--out.\n"
    "Exit codes: 0 nothing found, 1 failures found, 2 wrong usage, 3 internal error.";

constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kMostShards = 1'000'000;
constexpr std::uint64_t kMostRuns = 1'000'000'000;
constexpr std::uint64_t kMostJobs = 256;
constexpr double kMostSeconds = 1e6;
constexpr double kMostMegabytes = 1e7;

/// The words of the command line as they were given: CLI11 would wrap negative numbers and cut long ones.
struct Words {
  std::string against, manifolds, families, points = "1..40", capabilities, flatdt, claims;
  std::optional<std::string> time, cases, only, shard;
  std::string seed = "1", jobs = "1";
  std::string cpu_seconds = "10", wall_seconds = "60";
  std::string memory_megabytes = "2048", address_megabytes = "8192", output_megabytes = "64";
  std::string minimise_each = "5", minimise_runs = "600", minimise_seconds = "60";
};

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

void read_points(const std::string& text, Plan& plan) {
  const std::size_t dots = text.find("..");
  const std::string low = text.substr(0, dots),
                    high = dots == std::string::npos ? low : text.substr(dots + 2);
  plan.min_points = static_cast<long>(whole_number(low, "A of --points A..B", 1, kMostPoints));
  plan.max_points = static_cast<long>(whole_number(high, "B of --points A..B", 1, kMostPoints));
  if (plan.max_points < plan.min_points) throw UsageError("--points A..B needs A <= B, not " + text);
}

void read_manifolds(const std::string& text, Plan& plan) {
  plan.manifolds = split_list(text);
  for (const std::string& name : plan.manifolds)
    if (ref::find_entry(name) == nullptr) throw UsageError("no manifold is called \"" + name + "\"");
  if (!plan.manifolds.empty()) return;
  // Without a choice: what the implementation says it accepts.
  for (const std::string& name : testing::all_manifolds()) {
    const auto& accepted = plan.capabilities.manifolds;
    if (accepted.empty() || std::any_of(accepted.begin(), accepted.end(), [&](const std::string& a) {
          return ref::find_entry(a) == ref::find_entry(name);
        }))
      plan.manifolds.push_back(name);
  }
}

void read_families(const std::string& text, Plan& plan) {
  plan.families = split_list(text);
  const std::vector<std::string> known = all_families();
  for (const std::string& family : plan.families)
    if (std::find(known.begin(), known.end(), family) == known.end()) {
      std::string complaint = "no family is called \"" + family + '"';
      for (const std::string& k : known)
        complaint.append(k == known.front() ? "; there are " : ", ").append(k);
      throw UsageError(complaint);
    }
  if (plan.families.empty()) plan.families = known;
}

/// The program flatdt: the one given, one beside this program (as installed, as built), or nothing.
std::string find_flatdt(const std::string& given) {
  std::error_code ignored;
  if (!given.empty()) {
    if (!std::filesystem::is_regular_file(given, ignored)) throw UsageError("there is no program " + given);
    return given;
  }
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const auto& candidate : {self / "flatdt", self / "../../ref/flatdt", self / "../../../ref/flatdt"})
    if (std::filesystem::is_regular_file(candidate, ignored))
      return std::filesystem::canonical(candidate).string();
  return {};
}

/// A limit that is not 0 stays one, however small: 0 is none.
std::uint64_t bytes(const std::string& megabytes, const char* option) {
  return static_cast<std::uint64_t>(std::ceil(amount(megabytes, option, kMostMegabytes) * 1048576.0));
}

void read_limits(const Words& words, Limits& limits) {
  limits.cpu_seconds = amount(words.cpu_seconds, "--time-limit", kMostSeconds);
  limits.wall_seconds = amount(words.wall_seconds, "--wall-limit", kMostSeconds);
  limits.memory_bytes = bytes(words.memory_megabytes, "--memory-limit");
  limits.address_bytes = bytes(words.address_megabytes, "--address-limit");
  limits.output_bytes = bytes(words.output_megabytes, "--output-limit");
}

/// How much of the campaign is run, and where.
void read_extent(const Words& words, Options& options) {
  options.plan.seed = whole_number(words.seed, "--seed", 0, kAny);
  if (words.cases) options.cases = whole_number(*words.cases, "--cases", 0, kAny);
  if (words.only) options.only = whole_number(*words.only, "--only", 0, kAny);
  if (words.time) options.seconds = parse_duration(*words.time);
  if (!options.seconds && !options.cases && !options.only) options.seconds = kDefaultSeconds;
  if (words.shard) {
    const std::size_t slash = words.shard->find('/');
    if (slash == std::string::npos) throw UsageError("--shard is i/n, for example 1/4");
    options.shards = whole_number(words.shard->substr(slash + 1), "n of --shard i/n", 1, kMostShards);
    options.shard = whole_number(words.shard->substr(0, slash), "i of --shard i/n", 1, options.shards);
  }
  options.jobs = static_cast<unsigned>(whole_number(words.jobs, "--jobs", 0, kMostJobs));
  if (options.jobs == 0)
    options.jobs = std::clamp(std::thread::hardware_concurrency(), 1U, static_cast<unsigned>(kMostJobs));
  options.minimise_each = whole_number(words.minimise_each, "--minimise-each", 0, kMostRuns);
  options.budget.runs = whole_number(words.minimise_runs, "--minimise-runs", 0, kMostRuns);
  options.budget.seconds = amount(words.minimise_seconds, "--minimise-time", kMostSeconds);
}

void read_contact(const Words& words, Options& options) {
  Contact& contact = options.contact;
  try {
    if (!words.against.empty()) contact.command = split_command(words.against);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--against: ") + error.what());
  }
  if (contact.command.empty()) {
    if (contact.persistent) throw UsageError("--persistent needs --against");
    if (options.flatdt.empty())
      throw UsageError("the program flatdt is not beside this one: give --flatdt FILE");
    contact.command = {options.flatdt, "triangulate", "{instance}", "-o", "{output}"};
  }
  if (contact.persistent && (has_place(contact.command, "instance") || has_place(contact.command, "output")))
    throw UsageError(
        "a persistent command reads and writes its standard streams: no {instance}, no {output}");
  contact.unsupported_exit = options.plan.capabilities.unsupported_exit;
  read_limits(words, contact.limits);
  options.against = words.against.empty() ? "flatdt" : words.against;
}

void interpret(const Words& words, Options& options) {
  Capabilities& capabilities = options.plan.capabilities;
  if (!words.capabilities.empty()) {
    try {
      capabilities = read_capabilities(words.capabilities);
    } catch (const std::runtime_error& error) {
      throw UsageError(error.what());
    }
  }
  if (words.claims == "edges") capabilities.claim = Claim::edges;
  if (words.claims == "triangulation") capabilities.claim = Claim::triangulation;
  read_points(words.points, options.plan);
  read_manifolds(words.manifolds, options.plan);
  read_families(words.families, options.plan);
  options.flatdt = find_flatdt(words.flatdt);
  read_contact(words, options);
  read_extent(words, options);
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv) {
  Options options;
  Words words;
  CLI::App app(
      "Tests an implementation of periodic Delaunay triangulations: draws instances, runs the "
      "implementation,\n"
      "proves or refutes every output, and shrinks what is wrong.");
  app.footer(kFooter);
  app.add_option("--against", words.against,
                 "command line of the implementation, with {instance} and {output}");
  app.add_flag("--persistent", options.contact.persistent,
               "one process answers many instances (docs/campaigns.md)");
  app.add_option("--capabilities", words.capabilities, "JSON file: what the implementation accepts");
  app.add_option("--claims", words.claims, "triangulation or edges (default: as the capabilities say)")
      ->check(CLI::IsMember({"triangulation", "edges"}));
  app.add_option("--manifold", words.manifolds, "names, with commas (default: all that are accepted)");
  app.add_option("--family", words.families, "families of point sets, with commas (default: all); or list");
  app.add_option("--points", words.points, "numbers of points, A..B")->capture_default_str();
  // CLI11 would take an empty word for no word.
  const auto optional = [&](const char* option, std::optional<std::string>& text, const char* help) {
    app.add_option_function<std::string>(
        option, [&text](const std::string& word) { text = word; }, help);
  };
  optional("--time", words.time, "stop after this time: 90, 10m, 1h (default: 60 s)");
  optional("--cases", words.cases, "stop after so many cases, counted over all shards");
  optional("--only", words.only, "run this case only");
  const auto number = [&](const char* option, std::string& text, const char* help) {
    app.add_option(option, text, help)->capture_default_str();
  };
  number("--seed", words.seed, "seed of the cases");
  number("--jobs", words.jobs, "cases at a time (0: one for each processor; at most 256)");
  optional("--shard", words.shard, "i/n: the i-th of n parts of the cases, from 1");
  number("--out", options.out, "folder for everything that is written");
  app.add_flag("--resume", options.resume, "go on with the campaign in the folder");
  number("--time-limit", words.cpu_seconds, "CPU seconds of the child a case (0: none)");
  number("--wall-limit", words.wall_seconds, "seconds a case by the clock (0: none)");
  number("--memory-limit", words.memory_megabytes, "resident MB of the child (0: none)");
  number("--address-limit", words.address_megabytes, "MB of address space of the child (0: none)");
  number("--output-limit", words.output_megabytes, "MB of output (0: none)");
  number("--minimise-each", words.minimise_each, "failures to shrink that fail in the same way");
  number("--minimise-runs", words.minimise_runs, "runs to shrink one failure");
  number("--minimise-time", words.minimise_seconds, "seconds to shrink one failure");
  app.add_option("--flatdt", words.flatdt,
                 "the program flatdt, for pictures (default: the one beside this one)");
  app.add_flag_callback(
      "--version", [] { throw CLI::Success(); }, "print the version");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::fputs(app.help().c_str(), stdout);
    return std::nullopt;
  } catch (const CLI::Success&) {
    std::puts("flatdt-campaign " FLATDT_VERSION);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  if (words.families == "list") {
    for (const std::string& family : all_families()) std::puts(family.c_str());
    return std::nullopt;
  }
  interpret(words, options);
  return options;
}

}  // namespace flatdt::campaign
