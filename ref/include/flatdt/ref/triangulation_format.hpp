/// Reader and writer of `flatdt-triangulation 1` files.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "flatdt/ref/isometry.hpp"

namespace flatdt::ref {

/// A triangulation of E^d/H as lists: each cell has d+1 pairs (point index, element index); the vertex is
/// elements[k] * points[i]. All in instance coordinates.
struct Triangulation {
  int dimension = 0;
  /// Generators of H; empty and has_subgroup == false for the manifold itself.
  bool has_subgroup = false;
  std::vector<Isometry> subgroup;
  std::vector<Isometry> elements;
  struct CellVertex {
    std::uint32_t point;
    std::uint32_t element;
  };
  std::vector<std::array<CellVertex, 4>> cells;
};

/// Parses a whole file. Errors: InvalidInput "file:line: reason"; an index out of range is an error.
/// `points` is the number of points of the instance.
Triangulation parse_triangulation(std::string_view text, const std::string& file_name, int dimension,
                                  std::size_t points);

/// The text of the file. `comments` are written as `# ...` lines after the header.
std::string write_triangulation(const Triangulation& triangulation, const std::vector<std::string>& comments);

/// The same text piece by piece: of some million cells it is larger than the cells. The first piece has
/// everything that can fail.
using TextSink = std::function<void(std::string_view)>;
void write_triangulation(const Triangulation& triangulation, const std::vector<std::string>& comments,
                         const TextSink& sink);

}  // namespace flatdt::ref
