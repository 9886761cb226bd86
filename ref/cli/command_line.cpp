#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <new>
#include <sstream>

#include "commands.hpp"
#include "examples.hpp"
#include "flatdt/ref/errors.hpp"
#include "text_files.hpp"

namespace flatdt::ref::cli {
namespace {

constexpr int kBadInput = 2;
constexpr int kInternal = 3;

/// CLI11 wraps negative numbers and clamps large ones.
std::string is_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  const bool good = error == std::errc{} && end == text.data() + text.size();
  return good ? std::string() : "a seed is an integer from 0 to 2^64 - 1, not '" + text + "'";
}

int parse_and_run(int argc, const char* const* argv) {
  CLI::App app{"Delaunay triangulations of point sets in closed flat manifolds, exactly.", "flatdt"};
  app.set_version_flag("--version", std::string("flatdt ") + FLATDT_VERSION);
  app.require_subcommand(1);
  std::function<int()> action;

  ManifoldsOptions manifolds;
  auto* command =
      app.add_subcommand("manifolds", "List the catalogue: names, generators, metrics, delta^2, H1, sheets");
  command->add_flag("--json", manifolds.json, "Print one JSON object");
  command->callback([&] { action = [&] { return run_manifolds(manifolds); }; });

  InfoOptions info;
  command = app.add_subcommand("info", "Analyse the group of an instance");
  command->add_option("instance", info.instance, "Instance file, - for standard input")->required();
  command->add_flag("--json", info.json, "Print one JSON object");
  command->callback([&] { action = [&] { return run_info(info); }; });

  GenerateOptions generate;
  command = app.add_subcommand("generate", "Generate an instance of a named family");
  command->add_option("--manifold", generate.manifold, "Name or alias from `flatdt manifolds`");
  command->add_option("--points", generate.points, "Number of points")->capture_default_str();
  command->add_option("--family", generate.family, "Family of point sets; `--family list` lists them")
      ->capture_default_str();
  command->add_option("--seed", generate.seed, "Seed; the same seed gives the same bytes")
      ->check(is_seed)
      ->capture_default_str();
  command->add_option("--metric", generate.metric, "canonical or random")->capture_default_str();
  command->add_option("-o,--output", generate.output, "Output file, - for standard output")
      ->capture_default_str();
  command->callback([&] { action = [&] { return run_generate(generate); }; });

  TriangulateOptions triangulate;
  command = app.add_subcommand("triangulate", "Triangulate an instance");
  command->add_option("instance", triangulate.instance, "Instance file, - for standard input")->required();
  command->add_option("-o,--output", triangulate.output, "Output file, - for standard output")
      ->capture_default_str();
  command->add_option("--json-summary", triangulate.json_summary, "Write a JSON summary to this file");
  const CLI::Option* engine =
      command
          ->add_option("--engine", triangulate.engine,
                       "without-covers, or covering (the paper's: in a cover first); the output is the same")
          ->check(CLI::IsMember({"without-covers", "covering"}))
          ->capture_default_str();
  const CLI::Option* sheets =
      command
          ->add_option(
              "--sheets", triangulate.sheets,
              "Covering used while inserting: smallest (least safe sublattice) or theorem10 (c times "
              "the lattice); implies --engine covering")
          ->check(CLI::IsMember({"smallest", "theorem10"}))
          ->capture_default_str();
  command
      ->add_option("--order", triangulate.order_seed,
                   "Seed of the internal insertion order; the output is the same")
      ->check(is_seed)
      ->capture_default_str();
  const CLI::Option* max_sheets = command
                                      ->add_option("--max-sheets", triangulate.max_sheets,
                                                   "Largest covering to work in; implies --engine covering")
                                      ->check(CLI::Range(1L, 1000000000L))
                                      ->capture_default_str();
  command->add_flag(
      "--smallest-cover", triangulate.smallest_cover,
      "Where the manifold has no triangulation: the smallest covering that has one of these points");
  command->add_flag("-q,--quiet", triangulate.quiet, "Nothing on standard error but errors");
  command->callback([&] {
    if (sheets->count() > 0 || max_sheets->count() > 0) {
      if (engine->count() > 0 && triangulate.engine != "covering")
        throw CLI::ValidationError("--sheets and --max-sheets belong to --engine covering");
      triangulate.engine = "covering";
    }
    action = [&] { return run_triangulate(triangulate); };
  });

  ImportOptions import_options;
  command = app.add_subcommand("import",
                               "Make an instance from a crystal structure (CIF, mmCIF, PDB; also gzip'ed)");
  command->add_option("file", import_options.file, "Crystal structure file")->required();
  command->add_option("-o,--output", import_options.output, "Output file, - for standard output")
      ->capture_default_str();
  command->add_option("--coincident", import_options.coincident, "Coincident sites: refuse or merge")
      ->check(CLI::IsMember({"refuse", "merge"}))
      ->capture_default_str();
  command->add_option("--altloc", import_options.altloc, "Alternative locations: first of each, or all")
      ->check(CLI::IsMember({"first", "all"}))
      ->capture_default_str();
  command->callback([&] { action = [&] { return run_import(import_options); }; });

  DrawOptions draw;
  command = app.add_subcommand(
      "draw", "Draw a triangulation, right or wrong: 2D as SVG, 3D as VTU (ParaView) or HTML (WebGL)");
  command->add_option("instance", draw.instance, "Instance file, - for standard input")->required();
  command->add_option("triangulation", draw.triangulation, "Triangulation file, - for standard input")
      ->required();
  command->add_option("-o,--output", draw.output, "Output file, - for standard output")
      ->capture_default_str();
  command
      ->add_option("--format", draw.format,
                   "svg, vtu or html; default by the name of the output, else svg in 2D and vtu in 3D")
      ->check(CLI::IsMember({"svg", "vtu", "html"}));
  CLI::Option* verdict = command->add_option("--verdict", draw.verdict,
                                             "What `flatdt-check --json` printed: highlight its witness");
  command->add_option("--condition", draw.condition, "Failing condition whose witness is shown")
      ->needs(verdict);
  command
      ->add_option(
          "--copies", draw.copies,
          "0: no copies; N: copies that fill N lattice cells in each direction (SVG: copies or none)")
      ->check(CLI::Range(0, 5));
  command->add_flag("--two-cycle", draw.show_two_cycle,
                    "Highlight a loop or 2-cycle of the quotient by the group");
  command->add_flag("--violation", draw.show_violation, "Highlight a circumdisk that contains a point (2D)");
  command->callback([&] { action = [&] { return run_draw(draw); }; });

  for (const Examples& examples : kExamples)
    (examples.command.empty() ? &app : app.get_subcommand(std::string(examples.command)))
        ->footer(examples.lines);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {  // the help, or the version
    std::ostringstream text;
    app.exit(wish, text, text);
    write_output("-", text.str());
    return 0;
  } catch (const CLI::ParseError& error) {
    const bool lacks_command = app.get_subcommands().empty() && argc > 1 && argv[1][0] != '-';
    if (lacks_command)
      std::fprintf(stderr, "flatdt: there is no command '%s'; `flatdt --help` lists them\n", argv[1]);
    if (!lacks_command) app.exit(error);
    return kBadInput;
  }
  return action();
}

int fail(int code, const char* reason) {
  std::fprintf(stderr, "flatdt: %s\n", reason);
  return code;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const InvalidInput& error) {
    return fail(kBadInput, error.what());
  } catch (const LimitReached& error) {
    return fail(kInternal, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kInternal, "out of memory");
  } catch (const std::exception& error) {
    return fail(kInternal, error.what());
  } catch (...) {
    return fail(kInternal, "unknown error");
  }
}

}  // namespace flatdt::ref::cli
