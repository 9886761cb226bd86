/// The faces of a triangulation modulo H, as sets of points of E^d.
/// Source: FORMAT.md: "a face is the H-orbit of a nonempty subset of the vertices of a lifted cell; two
/// vertices are
///         equal iff their points in E^d are".
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "oracle/group.hpp"

namespace flatdt::naive {

/// A set of points of E^d, ascending: the canonical one of its H-orbit.
using Face = std::vector<oracle::Vector>;

/// The corners `corners` of cell `cell`, moved by `mover` of H, are the face.
struct Occurrence {
  std::size_t cell;
  std::vector<std::size_t> corners;
  oracle::Seitz mover;
};

struct FaceComplex {
  int dimension = 0;
  oracle::Group subgroup;                          ///< H
  std::vector<std::vector<oracle::Vector>> cells;  ///< d+1 points each, as the file lifts them
  bool has_repeated_vertex = false;                ///< some cell has one point as two corners
  std::array<std::map<Face, std::vector<Occurrence>>, 4> faces{};  ///< by dimension of the face

  [[nodiscard]] std::size_t corners() const { return static_cast<std::size_t>(dimension) + 1; }
  [[nodiscard]] const std::map<Face, std::vector<Occurrence>>& facets() const {
    return faces[static_cast<std::size_t>(dimension) - 1];
  }
  /// The corner that an occurrence of a facet leaves out.
  [[nodiscard]] static std::size_t apex(const Occurrence& facet);
};

/// All faces of all cells. The canonical member of an orbit of faces: move each of its points in turn to the
/// canonical point of its orbit, sort, and take the least result; H acts freely, so this depends on the orbit
/// alone.
[[nodiscard]] FaceComplex face_complex(int dimension, const oracle::Group& subgroup,
                                       std::vector<std::vector<oracle::Vector>> cells);

}  // namespace flatdt::naive
