#include <limits>

#include "flatdt/ref/errors.hpp"
#include "scene_text.hpp"

namespace flatdt::ref {
namespace {

constexpr int kDigits = 9;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The arrays of the file, written as they grow.
struct Arrays {
  std::string points, point_at;
  std::string connectivity, offsets, types, cell, copy, violated, figure;
  std::size_t point_count = 0, cell_count = 0, corner_count = 0;

  std::size_t add_point(const Place3& p, const Place3& shift, const std::string& index) {
    for (std::size_t k = 0; k < 3; ++k)
      points += decimal_text(p[k] + shift[k], kDigits) + (k < 2 ? " " : "\n");
    point_at += index + "\n";
    return point_count++;
  }
  void add_corner(std::size_t point) {
    connectivity += std::to_string(point) + " ";
    ++corner_count;
  }
  void end_cell(int type, const std::string& index, std::size_t copy_number, bool is_violated, int kind) {
    if (++cell_count > kMaxSceneCells)
      throw LimitReached("more than " + std::to_string(kMaxSceneCells) + " cells: too many to draw");
    connectivity += "\n";
    offsets += std::to_string(corner_count) + "\n";
    types += std::to_string(type) + "\n";
    cell += index + "\n";
    copy += std::to_string(copy_number) + "\n";
    violated += is_violated ? "1\n" : "0\n";
    figure += std::to_string(kind) + "\n";
  }
};

/// VTK's number of a simplex.
int type_of(std::size_t corners) {
  constexpr std::array<int, 5> kTypes = {0, 1 /* vertex */, 3 /* line */, 5 /* triangle */, 10 /* tetra */};
  return kTypes.at(corners);
}

void add_cells(Arrays& arrays, const Scene& scene, const Place3& shift, std::size_t translate, bool images) {
  std::vector<std::size_t> id(scene.places.size(), kNone);
  const auto corners = static_cast<std::size_t>(scene.dimension) + 1;
  for (const Scene::Cell& cell : scene.cells) {
    if (cell.image != 0 && !images) continue;
    for (std::size_t k = 0; k < corners; ++k) {
      const std::uint32_t place = cell.corners[k];
      if (id[place] == kNone)
        id[place] = arrays.add_point(scene.places[place], shift, std::to_string(scene.point_at[place]));
      arrays.add_corner(id[place]);
    }
    const bool is_copy = cell.image != 0 || translate != 0;
    arrays.end_cell(type_of(corners), std::to_string(cell.index), is_copy ? translate * 64 + cell.image : 0,
                    scene.is_violated[cell.index], 0);
  }
}

void add_figures(Arrays& arrays, const Scene& scene) {
  for (const Scene::Figure& figure : scene.figures) {
    for (const Place3& p : figure.corners) arrays.add_corner(arrays.add_point(p, {}, "-1"));
    arrays.end_cell(type_of(figure.corners.size()), "-1", 0, true, 1 + static_cast<int>(figure.kind));
  }
}

std::string array_text(const char* type, const std::string& name, const std::string& values,
                       const std::string& more = "") {
  return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\"" + more +
         " format=\"ascii\">\n" + values + "</DataArray>\n";
}

}  // namespace

std::string vtu_text(const Scene& scene, int copies) {
  Arrays arrays;
  const bool images = copies > 0;
  const int side = images && scene.has_copies ? copies : 1;
  std::size_t translate = 0;
  const int third = scene.dimension == 3 ? side : 1;
  for (int k = 0; k < third; ++k) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        Place3 shift{};
        for (std::size_t x = 0; x < 3; ++x)
          shift[x] = i * scene.lattice[0][x] + j * scene.lattice[1][x] + k * scene.lattice[2][x];
        add_cells(arrays, scene, shift, translate++, images);
      }
    }
  }
  add_figures(arrays, scene);
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
         std::to_string(arrays.point_count) + "\" NumberOfCells=\"" + std::to_string(arrays.cell_count) +
         "\">\n<PointData Scalars=\"point\">\n" + array_text("Int32", "point", arrays.point_at) +
         "</PointData>\n<CellData Scalars=\"violated\">\n" + array_text("Int32", "cell", arrays.cell) +
         array_text("Int32", "copy", arrays.copy) + array_text("Int32", "violated", arrays.violated) +
         array_text("Int32", "figure", arrays.figure) + "</CellData>\n<Points>\n" +
         array_text("Float64", "Points", arrays.points, " NumberOfComponents=\"3\"") +
         "</Points>\n<Cells>\n" + array_text("Int64", "connectivity", arrays.connectivity) +
         array_text("Int64", "offsets", arrays.offsets) + array_text("UInt8", "types", arrays.types) +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace flatdt::ref
