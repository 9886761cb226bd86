/// The subcommands of `flatdt`: one option struct and one function each. main.cpp parses the command line.
/// Every function returns the exit code 0 and throws InvalidInput (exit 2), LimitReached or anything else
/// (exit 3).
#pragma once

#include <cstdint>
#include <string>

namespace flatdt::ref::cli {

struct ManifoldsOptions {
  bool json = false;
};
int run_manifolds(const ManifoldsOptions& options);

struct InfoOptions {
  std::string instance;
  bool json = false;
};
int run_info(const InfoOptions& options);

struct GenerateOptions {
  std::string manifold;
  long points = 1;
  std::string family = "uniform";
  std::uint64_t seed = 0;
  std::string metric = "canonical";  // or "random"
  std::string output = "-";
};
int run_generate(const GenerateOptions& options);

struct TriangulateOptions {
  std::string instance;
  std::string output = "-";
  std::string json_summary;               // empty: none
  std::string engine = "without-covers";  // or "covering"
  std::string sheets = "smallest";        // or "theorem10"
  bool smallest_cover = false;
  std::uint64_t order_seed = 0;  // internal insertion order; the output does not depend on it
  long max_sheets = 20000;
  bool quiet = false;
};
int run_triangulate(const TriangulateOptions& options);

struct ImportOptions {
  std::string file;
  std::string output = "-";
  std::string coincident = "refuse";  // or "merge"
  std::string altloc = "first";       // or "all"
};
int run_import(const ImportOptions& options);
/// The text of the instance that the bytes of a crystal structure file mean. options.file names it in
/// messages; notes go to standard error.
std::string import_text(const std::string& bytes, const ImportOptions& options);

struct DrawOptions {
  std::string instance;
  std::string triangulation;
  std::string output = "-";
  std::string verdict;    // file of a verdict; empty: none
  std::string condition;  // of the verdict; empty: the first with a figure
  std::string format;     // svg, vtu or html; empty: by the name of the output
  int copies = -1;        // lattice cells along each direction; 0: one copy of each cell; -1: as usual
  bool show_two_cycle = false;
  bool show_violation = false;
};
int run_draw(const DrawOptions& options);

}  // namespace flatdt::ref::cli
