#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <thread>

#include "command_template.hpp"

namespace flatdt::campaign {
namespace {

constexpr double kDefaultSeconds = 60;
constexpr const char* kFooter =
    "Examples:\n"
    "  flatdt-campaign --time 10m --jobs 2\n"
    "  flatdt-campaign --against './mine {instance} {output}' --manifold torus --points 1..100 --time 1h\n"
    "  flatdt-campaign --against './mine --loop' --persistent --capabilities mine.json --cases 10000 --seed "
    "7\n"
    "Without --against the campaign tests flatdt. Results, reports and minimised failures are written to "
    "--out.\n"
    "Exit codes: 0 nothing found, 1 failures found, 2 wrong usage, 3 internal error.";

/// The words of the command line as they were given.
struct Words {
  std::string against, manifolds, families, points = "1..40", time, shard, capabilities, flatdt, claims;
  double memory_megabytes = 2048, address_megabytes = 8192, output_megabytes = 64;
};

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

std::uint64_t whole_number(const std::string& text, const std::string& what) {
  if (text.empty() || text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos)
    throw UsageError(what + " must be a whole number, not \"" + text + "\"");
  return std::stoull(text);
}

void read_points(const std::string& text, Plan& plan) {
  const std::size_t dots = text.find("..");
  const std::string low = text.substr(0, dots),
                    high = dots == std::string::npos ? low : text.substr(dots + 2);
  plan.min_points = static_cast<long>(whole_number(low, "--points"));
  plan.max_points = static_cast<long>(whole_number(high, "--points"));
  if (plan.min_points < 1 || plan.max_points < plan.min_points || plan.max_points > 1'000'000)
    throw UsageError("--points A..B needs 1 <= A <= B <= 1000000");
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
      std::string names;
      for (const std::string& k : known) names += (names.empty() ? "" : ", ") + k;
      throw UsageError("no family is called \"" + family + "\"; there are " + names);
    }
  if (plan.families.empty()) plan.families = known;
}

/// The program flatdt: the one given, one beside this program (as installed, as built), or nothing.
std::string find_flatdt(const std::string& given) {
  if (!given.empty()) {
    if (!std::filesystem::exists(given)) throw UsageError("there is no program " + given);
    return given;
  }
  std::error_code ignored;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const auto& candidate : {self / "flatdt", self / "../../ref/flatdt", self / "../../../ref/flatdt"})
    if (std::filesystem::is_regular_file(candidate, ignored))
      return std::filesystem::canonical(candidate).string();
  return {};
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
  const auto bytes = [](double megabytes) {
    return static_cast<std::uint64_t>(std::max(0.0, megabytes) * 1048576.0);
  };
  contact.limits.memory_bytes = bytes(words.memory_megabytes);
  contact.limits.address_bytes = bytes(words.address_megabytes);
  contact.limits.output_bytes = bytes(words.output_megabytes);
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
  if (!words.time.empty()) options.seconds = parse_duration(words.time);
  if (!options.seconds && !options.cases && !options.only) options.seconds = kDefaultSeconds;
  if (!words.shard.empty()) {
    const std::size_t slash = words.shard.find('/');
    if (slash == std::string::npos) throw UsageError("--shard is i/n, for example 1/4");
    options.shard = whole_number(words.shard.substr(0, slash), "--shard");
    options.shards = whole_number(words.shard.substr(slash + 1), "--shard");
    if (options.shard < 1 || options.shard > options.shards)
      throw UsageError("--shard i/n needs 1 <= i <= n");
  }
  if (options.jobs == 0) options.jobs = std::max(1U, std::thread::hardware_concurrency());
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
  app.add_option("--family", words.families, "families of point sets, with commas (default: all)");
  app.add_option("--points", words.points, "numbers of points, A..B")->capture_default_str();
  app.add_option("--time", words.time, "stop after this time: 90, 10m, 1h (default: 60 s)");
  app.add_option("--cases", options.cases, "stop after so many cases, counted over all shards");
  app.add_option("--only", options.only, "run this case only");
  app.add_option("--seed", options.plan.seed, "seed of the cases")->capture_default_str();
  app.add_option("--jobs", options.jobs, "cases at a time (0: one for each processor; at most 256)")
      ->check(CLI::Range(0U, 256U))
      ->capture_default_str();
  app.add_option("--shard", words.shard, "i/n: the i-th of n parts of the cases, from 1");
  app.add_option("--out", options.out, "folder for everything that is written")->capture_default_str();
  app.add_flag("--resume", options.resume, "go on with the campaign in the folder");
  app.add_option("--time-limit", options.contact.limits.cpu_seconds, "CPU seconds a case")
      ->capture_default_str();
  app.add_option("--wall-limit", options.contact.limits.wall_seconds, "seconds a case by the clock")
      ->capture_default_str();
  app.add_option("--memory-limit", words.memory_megabytes, "resident MB of the child (0: none)")
      ->capture_default_str();
  app.add_option("--address-limit", words.address_megabytes, "MB of address space of the child (0: none)")
      ->capture_default_str();
  app.add_option("--output-limit", words.output_megabytes, "MB of output (0: none)")->capture_default_str();
  app.add_option("--minimise-each", options.minimise_each, "failures to shrink that fail in the same way")
      ->capture_default_str();
  app.add_option("--minimise-runs", options.budget.runs, "runs to shrink one failure")->capture_default_str();
  app.add_option("--minimise-time", options.budget.seconds, "seconds to shrink one failure")
      ->capture_default_str();
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
  interpret(words, options);
  return options;
}

}  // namespace flatdt::campaign
