// The parser of instance files.   Source: FORMAT.md, "Instance".
#include <string>

#include "catalogue.hpp"
#include "flatdt/checker/errors.hpp"
#include "flatdt/checker/input.hpp"
#include "lexer.hpp"
#include "linear.hpp"
#include "parse_element.hpp"
#include "reserve_ahead.hpp"

namespace flatdt::checker {
namespace {

constexpr std::uint64_t kMaxPoints = 100'000'000;

const Manifold* parse_claim(Lexer& lexer, Instance& instance, std::string& name) {
  name = lexer.next();
  const Manifold* manifold = find_manifold(name);
  if (manifold == nullptr)
    lexer.fail("unknown manifold " + lexer.found() + "; expected a name or alias of the catalogue");
  if (manifold->dimension != instance.dimension) {
    lexer.fail("manifold " + lexer.found() + " has dimension " + std::to_string(manifold->dimension) +
               ", not " + std::to_string(instance.dimension));
  }
  instance.claim = std::string(manifold->name);
  return manifold;
}

/// Sylvester: a symmetric matrix is positive definite iff its leading principal minors are positive.
Mat<Rational> parse_metric(Lexer& lexer, int dimension) {
  Mat<Rational> gram;
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = i; j < d; ++j) {
      lexer.number("an entry of the metric", gram[i][j]);
      if (i != j) gram[j][i] = gram[i][j];
    }
  }
  for (int minor = 1; minor <= dimension; ++minor) {
    if (determinant(minor, gram) <= 0) {
      lexer.fail("the metric is not positive definite: its leading minor of order " + std::to_string(minor) +
                 " is not positive");
    }
  }
  return gram;
}

}  // namespace

Instance parse_instance(std::istream& in, const std::string& file) {
  Lexer lexer(in, file);
  lexer.expect("flatdt-instance");
  lexer.expect("1");
  lexer.expect("dimension");
  Instance instance;
  instance.dimension = static_cast<int>(lexer.count("the dimension", 2, 3));
  const int d = instance.dimension;

  std::string keyword(lexer.next());
  const Manifold* manifold = nullptr;
  std::string claimed;
  bool has_generators = false;
  instance.group_location = lexer.location();
  if (keyword == "manifold") {
    manifold = parse_claim(lexer, instance, claimed);
    keyword = lexer.next();
  }
  if (keyword == "generators") {
    instance.group_location = lexer.location();
    has_generators = true;
    instance.generators = parse_generators(lexer, d, 1);
    keyword = lexer.next();
  }
  if (!has_generators) {
    if (manifold == nullptr) lexer.fail("expected 'manifold' or 'generators', found " + lexer.found());
    instance.generators = catalogue_generators(*manifold, claimed);
  }
  if (keyword == "metric") {
    instance.metric = parse_metric(lexer, d);
    keyword = lexer.next();
  } else if (!has_generators) {
    instance.metric = canonical_metric(*manifold);
  } else {
    instance.metric = identity<Rational>(d);
  }
  if (keyword != "points") {
    lexer.fail(
        "expected 'points' (sections: dimension, manifold, generators, metric, points, in this order), "
        "found " +
        lexer.found());
  }
  const std::uint64_t n = lexer.count("the number of points", 1, kMaxPoints);
  for (std::uint64_t i = 0; i < n; ++i) {
    reserve_ahead(instance.points, n);
    Vec<Rational>& point = instance.points.emplace_back();
    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) lexer.number("a coordinate", point[k]);
  }
  lexer.expect_end();
  return instance;
}

}  // namespace flatdt::checker
