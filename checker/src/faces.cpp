#include "faces.hpp"

#include <algorithm>
#include <utility>

namespace flatdt::checker {

bool repeats_vertex(const Cell& cell, const Offsets& offset, const Corners& corners, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (cell.vertex[corners[k]] == cell.vertex[corners[i]] && offset[corners[k]][corners[i]] == kIdentity) {
        return true;
      }
    }
  }
  return false;
}

void make_canonical(const Cell& cell, const Offsets& offset, Corners& corners, std::size_t size) {
  VertexId least = cell.vertex[corners[0]];
  for (std::size_t k = 1; k < size; ++k) least = std::min(least, cell.vertex[corners[k]]);
  const Corners given = corners;
  std::optional<FaceKey> best;
  for (std::size_t b = 0; b < size; ++b) {
    if (cell.vertex[given[b]] != least) continue;
    Corners order = given;
    const auto entry = [&](std::uint8_t i) { return std::pair(cell.vertex[i], offset[given[b]][i]); };
    for (std::size_t k = 1; k < size; ++k) {  // insertion sort of at most four
      for (std::size_t i = k; i > 0 && entry(order[i]) < entry(order[i - 1]); --i) {
        std::swap(order[i], order[i - 1]);
      }
    }
    const FaceKey key = key_of(cell, offset, order, size);
    if (best && *best <= key) continue;
    best = key;
    corners = order;
  }
}

FaceKey key_of(const Cell& cell, const Offsets& offset, const Corners& corners, std::size_t size) {
  FaceKey key;
  for (std::size_t k = 0; k < size; ++k) {
    key.vertex[k] = static_cast<std::uint32_t>(cell.vertex[corners[k]]);
    if (k > 0) key.offset[k - 1] = static_cast<std::uint32_t>(offset[corners[0]][corners[k]]);
  }
  return key;
}

Corners side_corners(const Complex& complex, std::uint8_t facet) {
  Corners corners{};
  std::size_t n = 0;
  for (std::uint8_t i = 0; i < complex.corners; ++i) {
    if (i != facet) corners[n++] = i;
  }
  return corners;
}

Corners facet_corners(const Complex& complex, const Occurrence& occurrence) {
  const Cell& cell = complex.cells[index(occurrence.cell)];
  Corners corners = side_corners(complex, occurrence.facet);
  make_canonical(cell, complex.offsets(cell), corners, complex.corners - 1);
  return corners;
}

FaceKey key_of_facet(const Complex& complex, const Occurrence& occurrence) {
  const Cell& cell = complex.cells[index(occurrence.cell)];
  return key_of(cell, complex.offsets(cell), facet_corners(complex, occurrence), complex.corners - 1);
}

}  // namespace flatdt::checker
