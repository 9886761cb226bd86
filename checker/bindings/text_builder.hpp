// Files of both formats, written piece by piece for callers that hold numbers as strings.
//
// Invariants: what is added is made of tokens of the lexical rules, so that no piece can be taken for two or
// for another section; everything else is left to the parsers. A refused piece changes nothing.
// Source: FORMAT.md, "Lexical rules".
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace flatdt::checker {

/// A piece is no token, or has not as many tokens as the dimension asks for.
class RefusedPiece : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

using Tokens = std::span<const char* const>;

/// Counted lines of one section.
struct Section {
  std::size_t count = 0;
  std::string lines;
};

/// An instance file. Errors of all members: RefusedPiece, std::bad_alloc.
class InstanceBuilder {
 public:
  /// manifold: NULL for no claim. Requires: dimension 2 or 3, else RefusedPiece.
  InstanceBuilder(int dimension, const char* manifold);
  void add_generator(Tokens entries);
  void set_metric(Tokens upper_triangle);
  void add_point(Tokens coordinates);
  void add_point(std::span<const double> coordinates);
  [[nodiscard]] std::size_t dimension() const { return dimension_; }
  [[nodiscard]] std::string text() const;

 private:
  std::size_t dimension_;
  std::string claim_;
  std::string metric_;
  Section generators_;
  Section points_;
};

/// A triangulation file. Errors of all members: RefusedPiece, std::bad_alloc.
class TriangulationBuilder {
 public:
  /// Requires: dimension 2 or 3, else RefusedPiece.
  explicit TriangulationBuilder(int dimension);
  void add_subgroup_generator(Tokens entries);
  void add_element(Tokens entries);
  /// d + 1 pairs of a point's and an element's number.
  void add_cell(std::span<const std::uint32_t> pairs);
  [[nodiscard]] std::size_t dimension() const { return dimension_; }
  [[nodiscard]] std::string text() const;

 private:
  std::size_t dimension_;
  Section subgroup_;
  Section elements_;
  Section cells_;
};

}  // namespace flatdt::checker
