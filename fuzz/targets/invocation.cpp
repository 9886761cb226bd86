#include "invocation.hpp"

#include <algorithm>

namespace flatdt::fuzz {
namespace {

constexpr std::size_t kMaxArguments = 12;
constexpr std::size_t kMaxArgumentBytes = 40;
constexpr std::uint8_t kCheckerBit = 1;
constexpr std::uint8_t kCampaignBit = 4;

constexpr const char* kInstance =
    "flatdt-instance 1 dimension 2 manifold klein-bottle points 3 1/10 1/5 3/4 3/8 2/5 9/10\n";
constexpr const char* kTriangulation =
    "flatdt-triangulation 1 elements 2 1 0 0 0 1 0 1 0 1 0 1 0 cells 1 0 0 1 0 2 1\n";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string harmless(const std::string& argument) {
  std::string result;
  int digits = 0;
  for (const char c : argument) {
    digits = is_digit(c) ? digits + 1 : 0;
    if (c == '/' || c == 'x' || c == 'X' || digits > 2 || result.size() >= kMaxArgumentBytes) continue;
    result += c;
  }
  return result;
}

void read_arguments(std::string_view text, Invocation& line) {
  std::string argument;
  const auto finish = [&] {
    if (!argument.empty() && line.arguments.size() < kMaxArguments) line.arguments.push_back(argument);
    argument.clear();
  };
  for (const char c : text) {
    const auto byte = static_cast<std::uint8_t>(c);
    if (byte >= kFirstWord) {
      finish();
      argument = words()[static_cast<std::size_t>(byte - kFirstWord) % words().size()];
      finish();
    } else if (c == '\0' || c == ' ') {
      argument = harmless(argument);
      finish();
    } else {
      argument += c;
    }
  }
  argument = harmless(argument);
  finish();
}

}  // namespace

const std::vector<std::string>& words() {
  static const std::vector<std::string> list = {"manifolds",
                                                "info",
                                                "generate",
                                                "triangulate",
                                                "import",
                                                "draw",
                                                "i",
                                                "t",
                                                "-",
                                                "-o",
                                                "out",
                                                "--output",
                                                "--json",
                                                "--manifold",
                                                "--points",
                                                "--family",
                                                "--seed",
                                                "--metric",
                                                "--json-summary",
                                                "--sheets",
                                                "--order",
                                                "--max-sheets",
                                                "-q",
                                                "--quiet",
                                                "--coincident",
                                                "--altloc",
                                                "--two-cycle",
                                                "--violation",
                                                "--help",
                                                "--version",
                                                "list",
                                                "uniform",
                                                "cospherical",
                                                "lattice",
                                                "long-cell",
                                                "single-orbit",
                                                "canonical",
                                                "random",
                                                "smallest",
                                                "theorem10",
                                                "refuse",
                                                "merge",
                                                "first",
                                                "all",
                                                "torus",
                                                "klein-bottle",
                                                "G1",
                                                "dicosm",
                                                "P31",
                                                "P32",
                                                "G4",
                                                "hexacosm",
                                                "didicosm",
                                                "Pc",
                                                "Cc",
                                                "B3",
                                                "B4",
                                                "1",
                                                "2",
                                                "7",
                                                "99",
                                                "-1",
                                                "0",
                                                "1.5",
                                                "--",
                                                "=",
                                                "--json=1",
                                                "--points=3",
                                                "--seed=18446744073709551615",
                                                "--order=18446744073709551616",
                                                "--from",
                                                "cgal-p2t2",
                                                "cgal-p3t3",
                                                "--serve",
                                                "--max-bytes",
                                                "--max-seconds",
                                                "--jobs",
                                                "--verdict",
                                                "--condition",
                                                "volume.exact",
                                                "--copies",
                                                "--format",
                                                "svg",
                                                "vtu",
                                                "html",
                                                "--engine",
                                                "covering",
                                                "--smallest-cover",
                                                "--against",
                                                "--persistent",
                                                "--capabilities",
                                                "--claims",
                                                "edges",
                                                "--time",
                                                "--cases",
                                                "--only",
                                                "--shard=1/2",
                                                "--out",
                                                "--resume",
                                                "--time-limit",
                                                "--wall-limit",
                                                "--memory-limit",
                                                "--address-limit",
                                                "--output-limit",
                                                "--minimise-each",
                                                "--minimise-runs",
                                                "--minimise-time",
                                                "--flatdt",
                                                "1..9",
                                                "10m",
                                                "nan",
                                                "inf",
                                                "thin-band"};
  return list;
}

const char* name_of(Program program) {
  switch (program) {
    case Program::checker:
      return "flatdt-check";
    case Program::campaign:
      return "flatdt-campaign";
    case Program::reference:
      break;
  }
  return "flatdt";
}

Invocation invocation_of(std::span<const std::uint8_t> bytes) {
  Invocation line;
  if (bytes.empty()) return line;
  line.program = (bytes[0] & kCampaignBit) != 0  ? Program::campaign
                 : (bytes[0] & kCheckerBit) != 0 ? Program::checker
                                                 : Program::reference;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()) + 1, bytes.size() - 1);
  const std::size_t end = std::min(text.find('\n'), text.size());
  read_arguments(text.substr(0, end), line);
  const std::string_view files = text.substr(std::min(end + 1, text.size()));
  const std::size_t border = std::min(files.find('\0'), files.size());
  line.instance = files.substr(0, border);
  line.triangulation = files.substr(std::min(border + 1, files.size()));
  if (line.instance.empty()) line.instance = kInstance;
  if (line.triangulation.empty()) line.triangulation = kTriangulation;
  return line;
}

}  // namespace flatdt::fuzz
