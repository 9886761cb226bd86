// The two files as data, and their parsers.
//
// Invariants: what a parser returns obeys the grammar and the limits of FORMAT.md, indices are in range, the
// metric is positive definite, and the claimed name fits the dimension. Nothing is said about the group.
#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "flatdt/checker/exact.hpp"

namespace flatdt::checker {

/// An instance file. Coordinates are those of the file.
struct Instance {
  int dimension = 0;
  std::optional<std::string> claim;   ///< canonical name of the claimed manifold
  std::vector<Seitz> generators;      ///< the file's, or the catalogue's
  Mat<Rational> metric;               ///< Gram matrix of the basis, symmetric positive definite
  std::vector<Vec<Rational>> points;  ///< at least one
  std::string group_location;         ///< "file:line" of what fixes the group
};

/// One vertex of a cell in the file: the lift elements[element] * points[point].
struct FileVertex {
  std::uint32_t point;
  std::uint32_t element;
};
using FileCell = std::array<FileVertex, 4>;

/// A triangulation file. Elements share their numbers, of which there are few, so that an element costs 48
/// bytes.
struct Triangulation {
  int dimension = 0;
  std::optional<std::vector<Seitz>> subgroup;           ///< generators of H; absent: H = G
  std::vector<Rational> numbers;                        ///< distinct numbers of the elements
  std::vector<std::array<std::uint32_t, 12>> elements;  ///< indices into numbers, row by row
  std::vector<FileCell> cells;                          ///< the first d+1 entries count

  /// The k-th listed element. Requires: k in range.
  [[nodiscard]] Seitz element(std::size_t k) const;
};

/// Reads an instance to the end of the stream; `file` names it in errors.
/// Errors: MalformedInput; std::ios_base::failure if the stream cannot be read.
/// Cost: linear in the bytes read, apart from the arithmetic of single numbers; memory likewise.
/// Source: FORMAT.md, "Lexical rules" and "Instance".
[[nodiscard]] Instance parse_instance(std::istream& in, const std::string& file);

/// Reads a triangulation belonging to `instance`; otherwise as parse_instance.
/// Source: FORMAT.md, "Triangulation".
[[nodiscard]] Triangulation parse_triangulation(std::istream& in, const std::string& file,
                                                const Instance& instance);

}  // namespace flatdt::checker
