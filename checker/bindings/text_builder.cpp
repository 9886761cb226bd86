#include "text_builder.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

namespace flatdt::checker {
namespace {

constexpr std::size_t kMaxTokenBytes = 4096;

std::size_t checked_dimension(int dimension) {
  if (dimension != 2 && dimension != 3) throw RefusedPiece("the dimension must be 2 or 3");
  return static_cast<std::size_t>(dimension);
}

/// A token, which ends at a zero byte. At most one byte more than a token may have is looked at.
std::string_view checked_token(const char* token) {
  if (token == nullptr) throw RefusedPiece("a NULL where a string must stand");
  std::size_t size = 0;
  for (; token[size] != '\0'; ++size) {
    const char c = token[size];
    if (size == kMaxTokenBytes || c < 0x21 || c > 0x7E || c == '#') throw RefusedPiece("not a token");
  }
  if (size == 0) throw RefusedPiece("an empty string where a token must stand");
  return {token, size};
}

/// A line of `count` tokens, indented.
std::string line_of(Tokens tokens, std::size_t count) {
  if (tokens.size() != count) throw RefusedPiece("the count does not fit the dimension");
  std::string line = " ";
  for (const char* token : tokens) {
    line += ' ';
    line += checked_token(token);
  }
  return line + '\n';
}

void add(Section& section, const std::string& line) {
  section.lines += line;
  ++section.count;
}

void write(std::string& text, const char* keyword, const Section& section) {
  text += keyword;
  text += ' ' + std::to_string(section.count) + '\n';
  text += section.lines;
}

/// Hexadecimal digits, which lose nothing; not by printf, whose point is the locale's.
std::string hexadecimal(double x) {
  if (!std::isfinite(x)) throw RefusedPiece("a coordinate that is not finite");
  std::array<char, 40> digits{};
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), std::fabs(x), std::chars_format::hex);
  if (error != std::errc{}) throw RefusedPiece("a coordinate that has no digits");  // 40 hold every double
  return (std::signbit(x) ? "-0x" : "0x") + std::string(digits.data(), end);
}

}  // namespace

InstanceBuilder::InstanceBuilder(int dimension, const char* manifold)
    : dimension_(checked_dimension(dimension)) {
  if (manifold != nullptr) claim_ = checked_token(manifold);
}

void InstanceBuilder::add_generator(Tokens entries) {
  add(generators_, line_of(entries, dimension_ * (dimension_ + 1)));
}

void InstanceBuilder::set_metric(Tokens upper_triangle) {
  metric_ = line_of(upper_triangle, dimension_ * (dimension_ + 1) / 2);
}

void InstanceBuilder::add_point(Tokens coordinates) {
  add(points_, line_of(coordinates, dimension_));
}

void InstanceBuilder::add_point(std::span<const double> coordinates) {
  if (coordinates.size() != dimension_) throw RefusedPiece("the count does not fit the dimension");
  std::string line = " ";
  for (const double x : coordinates) line += ' ' + hexadecimal(x);
  add(points_, line + '\n');
}

std::string InstanceBuilder::text() const {
  std::string text = "flatdt-instance 1\ndimension " + std::to_string(dimension_) + '\n';
  if (!claim_.empty()) text += "manifold " + claim_ + '\n';
  if (generators_.count > 0) write(text, "generators", generators_);
  if (!metric_.empty()) text += "metric" + metric_;
  write(text, "points", points_);
  return text;
}

TriangulationBuilder::TriangulationBuilder(int dimension) : dimension_(checked_dimension(dimension)) {}

void TriangulationBuilder::add_subgroup_generator(Tokens entries) {
  add(subgroup_, line_of(entries, dimension_ * (dimension_ + 1)));
}

void TriangulationBuilder::add_element(Tokens entries) {
  add(elements_, line_of(entries, dimension_ * (dimension_ + 1)));
}

void TriangulationBuilder::add_cell(std::span<const std::uint32_t> pairs) {
  if (pairs.size() != 2 * (dimension_ + 1)) throw RefusedPiece("the count does not fit the dimension");
  std::string line = " ";
  for (const std::uint32_t index : pairs) line += ' ' + std::to_string(index);
  add(cells_, line + '\n');
}

std::string TriangulationBuilder::text() const {
  std::string text = "flatdt-triangulation 1\n";
  if (subgroup_.count > 0) write(text, "subgroup", subgroup_);
  write(text, "elements", elements_);
  write(text, "cells", cells_);
  return text;
}

}  // namespace flatdt::checker
