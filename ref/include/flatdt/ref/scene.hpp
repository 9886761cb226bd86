/// Triangulations in space for viewers: Cartesian coordinates, copies, the witness of a refutation.
/// Invariants: doubles only place things (nothing is decided by them) and the bytes are a function of the
/// arguments, as for SVG; whatever parses is shown or refused, however wrong the triangulation is.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/refutation.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::ref {

/// In Gram units of length; z = 0 in dimension 2.
using Place3 = std::array<double, 3>;

struct SceneOptions {
  bool show_two_cycle = false;
  std::optional<Verdict> verdict = std::nullopt;
  std::string condition = {};  // empty: the first that has a figure
};

struct Scene {
  /// A listed cell, or its image under another coset of the lattice of H, moved by the lattice so that its
  /// barycentre is in the lattice cell. Positively oriented.
  struct Cell {
    std::array<std::uint32_t, 4> corners;  // indices of places; the last is unused in dimension 2
    std::uint32_t index;                   // in the file
    std::uint32_t image;                   // 0: of the listed cell itself
  };
  struct Figure {
    Mark::Kind kind;
    std::vector<Place3> corners;
  };
  struct Sphere {
    Place3 centre;
    double radius;
  };

  int dimension = 0;
  std::string title;
  std::vector<std::string> notes;
  /// The reduced basis of the lattice of H; of G as well where H is smaller.
  std::array<Place3, 3> lattice{};
  std::optional<std::array<Place3, 3>> full_lattice;
  std::vector<Place3> places;
  std::vector<std::uint32_t> point_at;  // for each place: the index of a point
  std::vector<Cell> cells;
  /// False if the subgroup is not admissible: then there are no images, and nothing may be translated.
  bool has_copies = true;
  std::vector<bool> is_violated;  // by index in the file: the witness names the cell
  std::vector<Figure> figures;
  std::optional<Sphere> sphere;
};

inline constexpr std::size_t kMaxSceneCells = 400'000;

/// Errors: InvalidInput as draw_svg; LimitReached above kMaxSceneCells cells with their images, or if the
/// lattice is beyond the range of double.
Scene make_scene(const Instance& instance, const Triangulation& triangulation, const SceneOptions& options);

/// XML of VTK, UnstructuredGrid in ASCII, for ParaView: tetrahedra (triangles in dimension 2), then the
/// figures of the witness. Cell data `cell` (index in the file, -1: a figure), `copy` (0: the listed cell),
/// `violated` (1: the witness names it), `figure` (0: none, else 1 + Mark::Kind); point data `point` (-1: of
/// a figure). copies 0: one copy of each cell; N > 0: images and translates that fill N lattice cells in each
/// direction. Errors: LimitReached above kMaxSceneCells cells.
std::string vtu_text(const Scene& scene, int copies);

/// One HTML page that needs no network: WebGL with rotation, zoom, a slicing plane, copies, and the witness
/// highlighted. copies: shown at first. Errors: InvalidInput unless the dimension is 3.
std::string html_text(const Scene& scene, int copies);

}  // namespace flatdt::ref
