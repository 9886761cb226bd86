#include "flatdt/ref/catalogue.hpp"

#include <algorithm>
#include <sstream>

#include "catalogue_entries.hpp"
#include "flatdt/ref/errors.hpp"
#include "lexer.hpp"

namespace flatdt::ref {
namespace {

/// One row of [R|t] from one term of a coordinate triplet: signs, letters x, y, z, and at most one number,
/// which comes last.
void parse_row(const std::string& term, int row, Isometry& g) {
  Rational sign = 1;
  for (std::size_t i = 0; i < term.size(); ++i) {
    const char c = term[i];
    if (c == '+' || c == '-') {
      sign = c == '+' ? 1 : -1;
    } else if (c >= 'x' && c <= 'z') {
      g.linear(row, c - 'x') = sign;
    } else {
      g.translation[row] = sign * parse_number(std::string_view(term).substr(i));
      return;
    }
  }
}

Isometry parse_triplet(const std::string& triplet, int dimension) {
  Isometry g{Matrix(dimension), Vector(dimension)};
  std::istringstream terms(triplet);
  std::string term;
  int row = 0;
  while (std::getline(terms, term, ',')) parse_row(term, row++, g);
  ensure(row == dimension, "a catalogue element has one term for each coordinate");
  return g;
}

std::vector<Isometry> parse_triplets(const std::vector<std::string>& triplets, int dimension) {
  std::vector<Isometry> elements;
  elements.reserve(triplets.size());
  for (const std::string& triplet : triplets) elements.push_back(parse_triplet(triplet, dimension));
  return elements;
}

Matrix parse_gram(const std::string& upper_triangle, int dimension) {
  Matrix gram(dimension);
  std::istringstream numbers(upper_triangle);
  std::string number;
  for (int i = 0; i < dimension; ++i) {
    for (int j = i; j < dimension; ++j) {
      numbers >> number;
      gram(i, j) = parse_number(number);
      gram(j, i) = gram(i, j);
    }
  }
  return gram;
}

CatalogueEntry parse_entry(const CatalogueText& text) {
  const int d = text.dimension;
  return {.name = text.name,
          .aliases = text.aliases,
          .dimension = d,
          .space_groups = text.space_groups,
          .generators = parse_triplets(text.generators, d),
          .mirror_image_generators = parse_triplets(text.mirror_image_generators, d),
          .mirror_aliases = text.mirror_aliases,
          .coset_representatives = parse_triplets(text.coset_representatives, d),
          .canonical_gram = parse_gram(text.canonical_gram, d),
          .metric_cone = text.metric_cone,
          .holonomy = text.holonomy,
          .holonomy_order = static_cast<int>(text.coset_representatives.size()),
          .orientable = text.orientable,
          .h1 = text.h1,
          .delta_squared_formula = text.delta_squared_formula,
          .canonical_delta_squared = parse_number(text.canonical_delta_squared),
          .left_orderable = text.left_orderable,
          .left_order_coordinates = text.left_order_coordinates};
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

const std::vector<CatalogueEntry>& catalogue() {
  static const std::vector<CatalogueEntry> entries = [] {
    std::vector<CatalogueEntry> parsed;
    for (const CatalogueText& text : catalogue_texts()) parsed.push_back(parse_entry(text));
    return parsed;
  }();
  return entries;
}

const CatalogueEntry* find_entry(std::string_view name_or_alias) {
  for (const CatalogueEntry& entry : catalogue())
    if (entry.name == name_or_alias || contains(entry.aliases, name_or_alias)) return &entry;
  return nullptr;
}

const std::vector<Isometry>& generators_of(const CatalogueEntry& entry, std::string_view name_or_alias) {
  return contains(entry.mirror_aliases, name_or_alias) ? entry.mirror_image_generators : entry.generators;
}

}  // namespace flatdt::ref
