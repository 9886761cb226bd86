#include "flatdt/ref/instance_format.hpp"

#include <algorithm>
#include <utility>

#include "flatdt/ref/catalogue.hpp"
#include "flatdt/ref/errors.hpp"
#include "lexer.hpp"

namespace flatdt::ref {
namespace {

constexpr std::uint64_t kMaxGenerators = 10'000;
constexpr std::uint64_t kMaxPoints = 100'000'000;

int parse_dimension(Lexer& lexer) {
  lexer.expect("dimension");
  const std::uint64_t dimension = lexer.count("the dimension", kMaxDimension);
  if (dimension < 2) lexer.fail("the dimension must be 2 or 3");
  return static_cast<int>(dimension);
}

const CatalogueEntry& parse_name(Lexer& lexer, Instance& instance) {
  instance.name = std::string(lexer.word("the name of a manifold"));
  const CatalogueEntry* entry = find_entry(*instance.name);
  if (entry == nullptr)
    lexer.fail("no manifold is called \"" + instance.name->substr(0, 40) +
               "\": `flatdt manifolds` lists the names");
  if (entry->dimension != instance.dimension)
    lexer.fail(*instance.name + " has dimension " + std::to_string(entry->dimension) + ", the file says " +
               std::to_string(instance.dimension));
  return *entry;
}

void parse_generators(Lexer& lexer, Instance& instance) {
  const std::uint64_t count = lexer.count("the number of generators", kMaxGenerators);
  if (count == 0) lexer.fail("there must be at least one generator");
  for (std::uint64_t i = 0; i < count; ++i)
    instance.generators.push_back(lexer.isometry(instance.dimension, {"generator", i}));
}

Matrix parse_metric(Lexer& lexer, int dimension) {
  Matrix gram(dimension);
  for (int i = 0; i < dimension; ++i) {
    for (int j = i; j < dimension; ++j) {
      gram(i, j) = lexer.number("the metric");
      gram(j, i) = gram(i, j);
    }
  }
  return gram;
}

void parse_points(Lexer& lexer, Instance& instance) {
  const std::uint64_t count = lexer.count("the number of points", kMaxPoints);
  if (count == 0) lexer.fail("there must be at least one point");
  // A coordinate takes at least two bytes: a count alone costs no memory.
  const std::size_t fewest_bytes = 2 * static_cast<std::size_t>(instance.dimension);
  instance.points.reserve(std::min<std::size_t>(count, lexer.bytes_left() / fewest_bytes + 1));
  for (std::uint64_t i = 0; i < count; ++i) {
    Vector x(instance.dimension);
    for (int k = 0; k < instance.dimension; ++k) x[k] = lexer.number("a point");
    instance.points.push_back(std::move(x));
  }
}

}  // namespace

Instance parse_instance(std::string_view text, const std::string& file_name) {
  Lexer lexer(text, file_name);
  lexer.expect("flatdt-instance");
  lexer.expect("1");
  Instance instance;
  instance.dimension = parse_dimension(lexer);
  const CatalogueEntry* entry = nullptr;
  if (lexer.accept("manifold")) {
    instance.lines.manifold = lexer.line();
    entry = &parse_name(lexer, instance);
  }
  instance.generators_given = lexer.accept("generators");
  const bool is_by_name = !instance.generators_given;
  if (!is_by_name) {
    instance.lines.generators = lexer.line();
    parse_generators(lexer, instance);
  } else {
    if (entry == nullptr) lexer.fail("a \"manifold\" or a \"generators\" section must follow the dimension");
    instance.generators = generators_of(*entry, *instance.name);
  }
  if (lexer.accept("metric")) {
    instance.lines.metric = lexer.line();
    instance.gram = parse_metric(lexer, instance.dimension);
  } else {
    instance.gram = is_by_name ? entry->canonical_gram : Matrix::identity(instance.dimension);
  }
  lexer.expect("points");
  parse_points(lexer, instance);
  lexer.expect_end("point");
  return instance;
}

std::string write_instance(const Instance& instance) {
  const int d = instance.dimension;
  std::string text = "flatdt-instance 1\ndimension " + std::to_string(d) + "\n";
  if (instance.name) text += "manifold " + *instance.name + "\n";
  if (instance.generators_given) {
    text += "generators " + std::to_string(instance.generators.size()) + "\n";
    for (const Isometry& g : instance.generators) text += "  " + isometry_tokens(g) + "\n";
  }
  text += "metric";
  for (int i = 0; i < d; ++i)
    for (int j = i; j < d; ++j) text += " " + number_token(instance.gram(i, j));
  text += "\npoints " + std::to_string(instance.points.size()) + "\n";
  for (const Vector& x : instance.points) {
    for (int k = 0; k < d; ++k) text += (k > 0 ? " " : "  ") + number_token(x[k]);
    text += "\n";
  }
  return text;
}

}  // namespace flatdt::ref
