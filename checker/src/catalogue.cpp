#include "catalogue.hpp"

#include <array>
#include <sstream>
#include <string>

#include "lexer.hpp"

namespace flatdt::checker {
namespace {

// clang-format off
constexpr std::array<Manifold, 12> kCatalogue = {{
    {"torus", " p1 ", "", 2, true, "1", "Z^2", "1 0 1 0 1 0  1 0 0 0 1 1 ", "", false},
    {"klein-bottle", " pg ", "", 2, false, "Z2", "Z+Z/2", "1 0 1 0 1 0  -1 0 0 0 1 1/2 ", "", false},
    {"torocosm", " G1 P1 3-torus ", "", 3, true, "1", "Z^3",
     "1 0 0 1 0 1 0 0 0 0 1 0  1 0 0 0 0 1 0 1 0 0 1 0  1 0 0 0 0 1 0 0 0 0 1 1 ", "", false},
    {"dicosm", " G2 P21 ", "", 3, true, "Z2", "Z+Z/2+Z/2",
     "1 0 0 1 0 1 0 0 0 0 1 0  1 0 0 0 0 1 0 1 0 0 1 0  -1 0 0 0 0 -1 0 0 0 0 1 1/2 ", "", false},
    {"tricosm", " G3 P31 P32 ", " P32 ", 3, true, "Z3", "Z+Z/3",
     "1 0 0 1 0 1 0 0 0 0 1 0  0 -1 0 0 1 -1 0 0 0 0 1 1/3 ",
     "1 0 0 1 0 1 0 0 0 0 1 0  -1 1 0 0 -1 0 0 0 0 0 1 1/3 ", true},
    {"tetracosm", " G4 P41 P43 ", " P43 ", 3, true, "Z4", "Z+Z/2",
     "1 0 0 1 0 1 0 0 0 0 1 0  0 -1 0 0 1 0 0 0 0 0 1 1/4 ",
     "1 0 0 1 0 1 0 0 0 0 1 0  0 1 0 0 -1 0 0 0 0 0 1 1/4 ", false},
    {"hexacosm", " G5 P61 P65 ", " P65 ", 3, true, "Z6", "Z",
     "1 0 0 1 0 1 0 0 0 0 1 0  1 -1 0 0 1 0 0 0 0 0 1 1/6 ",
     "1 0 0 1 0 1 0 0 0 0 1 0  0 1 0 0 -1 1 0 0 0 0 1 1/6 ", true},
    {"didicosm", " G6 P212121 hantzsche-wendt ", "", 3, true, "Z2xZ2", "Z/4+Z/4",
     "1 0 0 1/2 0 -1 0 1/2 0 0 -1 0  -1 0 0 0 0 1 0 1/2 0 0 -1 1/2 ", "", false},
    {"first-amphicosm", " B1 Pc ", "", 3, false, "Z2", "Z^2+Z/2",
     "1 0 0 1 0 1 0 0 0 0 1 0  1 0 0 0 0 1 0 1 0 0 1 0  1 0 0 0 0 -1 0 0 0 0 1 1/2 ", "", false},
    {"second-amphicosm", " B2 Cc ", "", 3, false, "Z2", "Z^2",
     "1 0 0 1 0 1 0 0 0 0 1 0  0 1 0 0 1 0 0 0 0 0 1 1/2 ", "", false},
    {"first-amphidicosm", " B3 Pca21 ", "", 3, false, "Z2xZ2", "Z+Z/2+Z/2",
     "-1 0 0 0 0 -1 0 0 0 0 1 1/2  1 0 0 1/2 0 -1 0 0 0 0 1 0  1 0 0 0 0 1 0 1 0 0 1 0 ", "", false},
    {"second-amphidicosm", " B4 Pna21 ", "", 3, false, "Z2xZ2", "Z+Z/4",
     "-1 0 0 0 0 -1 0 0 0 0 1 1/2  1 0 0 1/2 0 -1 0 1/2 0 0 1 0 ", "", false},
}};
// clang-format on

bool lists(std::string_view words, std::string_view word) {
  return words.find(" " + std::string(word) + " ") != std::string_view::npos;
}

}  // namespace

const Manifold* find_manifold(std::string_view name) {
  for (const Manifold& m : kCatalogue) {
    if (m.name == name || lists(m.aliases, name)) return &m;
  }
  return nullptr;
}

std::optional<std::string_view> recognise(int dimension, bool orientable, std::string_view holonomy,
                                          std::string_view homology) {
  for (const Manifold& m : kCatalogue) {
    if (m.dimension == dimension && m.orientable == orientable && m.holonomy == holonomy &&
        m.homology == homology) {
      return m.name;
    }
  }
  return std::nullopt;
}

std::vector<Seitz> catalogue_generators(const Manifold& manifold, std::string_view name) {
  const std::string_view text = lists(manifold.mirror, name) ? manifold.mirrored : manifold.generators;
  std::istringstream in{std::string(text)};
  std::vector<Seitz> generators;
  const auto d = static_cast<std::size_t>(manifold.dimension);
  std::string token;
  for (std::size_t i = 0; in >> token; ++i) {
    const std::size_t row = i / (d + 1) % d;
    const std::size_t column = i % (d + 1);
    if (row == 0 && column == 0) generators.emplace_back();
    Seitz& g = generators.back();
    (column < d ? g.linear[row][column] : g.translation[row]) = parse_number(token);
  }
  return generators;
}

Mat<Rational> canonical_metric(const Manifold& manifold) {
  Mat<Rational> gram;
  for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.dimension); ++i) gram[i][i] = 1;
  if (manifold.hexagonal) gram[0][1] = gram[1][0] = Rational(-1, 2);
  return gram;
}

}  // namespace flatdt::checker
