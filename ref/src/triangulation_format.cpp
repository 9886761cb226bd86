#include "flatdt/ref/triangulation_format.hpp"

#include <charconv>

#include "lexer.hpp"

namespace flatdt::ref {
namespace {

// FORMAT: limits. Generators of the subgroup are generators.
constexpr std::uint64_t kMaxGenerators = 10'000;
constexpr std::uint64_t kMaxElements = 100'000'000;
constexpr std::uint64_t kMaxCells = 1'000'000'000;

std::vector<Isometry> parse_isometries(Lexer& lexer, int dimension, std::uint64_t count,
                                       std::string_view what) {
  std::vector<Isometry> list;  // grows with the text: a count alone must not cost memory
  for (std::uint64_t i = 0; i < count; ++i) list.push_back(lexer.isometry(dimension, {what, i}));
  return list;
}

void append_isometries(std::string& text, const std::string& keyword, const std::vector<Isometry>& list) {
  text += keyword + " " + std::to_string(list.size()) + "\n";
  for (const Isometry& g : list) text += "  " + isometry_tokens(g) + "\n";
}

/// A comment may hold line breaks: every line of it becomes a comment line.
void append_comment(std::string& text, const std::string& comment) {
  text += "# ";
  for (const char c : comment) {
    text += c;
    if (c == '\n') text += "# ";
  }
  text += '\n';
}

/// With a blank before it.
void append_number(std::string& text, std::uint32_t number) {
  std::array<char, 11> digits{' '};
  const auto end = std::to_chars(digits.data() + 1, digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

}  // namespace

Triangulation parse_triangulation(std::string_view text, const std::string& file_name, int dimension,
                                  std::size_t points) {
  Lexer lexer(text, file_name);
  lexer.expect("flatdt-triangulation");
  lexer.expect("1");
  Triangulation triangulation;
  triangulation.dimension = dimension;
  triangulation.has_subgroup = lexer.accept("subgroup");
  if (triangulation.has_subgroup) {
    const std::uint64_t count = lexer.count("the number of subgroup generators", kMaxGenerators);
    triangulation.subgroup = parse_isometries(lexer, dimension, count, "subgroup generator");
  }
  lexer.expect("elements");
  const std::uint64_t elements = lexer.count("the number of elements", kMaxElements);
  triangulation.elements = parse_isometries(lexer, dimension, elements, "element");
  lexer.expect("cells");
  const std::uint64_t cells = lexer.count("the number of cells", kMaxCells);
  for (std::uint64_t i = 0; i < cells; ++i) {
    std::array<Triangulation::CellVertex, 4> cell{};
    for (std::size_t k = 0; k <= static_cast<std::size_t>(dimension); ++k) {
      cell[k].point = static_cast<std::uint32_t>(lexer.index("a point index of a cell", points));
      cell[k].element = static_cast<std::uint32_t>(lexer.index("an element index of a cell", elements));
    }
    triangulation.cells.push_back(cell);
  }
  lexer.expect_end("cell");
  return triangulation;
}

void write_triangulation(const Triangulation& triangulation, const std::vector<std::string>& comments,
                         const TextSink& sink) {
  constexpr std::size_t kPiece = 1 << 16;
  std::string text = "flatdt-triangulation 1\n";
  for (const std::string& comment : comments) append_comment(text, comment);
  if (triangulation.has_subgroup) append_isometries(text, "subgroup", triangulation.subgroup);
  append_isometries(text, "elements", triangulation.elements);
  text += "cells " + std::to_string(triangulation.cells.size()) + "\n";
  for (const auto& cell : triangulation.cells) {
    text += ' ';
    for (std::size_t k = 0; k <= static_cast<std::size_t>(triangulation.dimension); ++k) {
      append_number(text, cell[k].point);
      append_number(text, cell[k].element);
    }
    text += '\n';
    if (text.size() < kPiece) continue;
    sink(text);
    text.clear();
  }
  sink(text);
}

std::string write_triangulation(const Triangulation& triangulation,
                                const std::vector<std::string>& comments) {
  std::string text;
  write_triangulation(triangulation, comments, [&text](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace flatdt::ref
