#include "faces.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace flatdt::checker {
namespace {

/// The list seen from corner b; `corners` is overwritten by the sorted order.
FaceKey list_from(const Cell& cell, std::uint8_t b, std::array<std::uint8_t, 4>& corners, std::size_t size) {
  const auto entry = [&](std::uint8_t i) { return std::pair(cell.vertex[i], cell.offset[b][i]); };
  for (std::size_t k = 1; k < size; ++k) {  // insertion sort of at most four
    for (std::size_t i = k; i > 0 && entry(corners[i]) < entry(corners[i - 1]); --i) {
      std::swap(corners[i], corners[i - 1]);
    }
  }
  FaceKey key;
  for (std::size_t k = 0; k < size; ++k) {
    key.vertex[k] = static_cast<std::uint32_t>(cell.vertex[corners[k]]);
    if (k > 0) key.offset[k - 1] = static_cast<std::uint32_t>(cell.offset[b][corners[k]]);
  }
  return key;
}

}  // namespace

CanonicalFace canonical_face(const Cell& cell, const std::array<std::uint8_t, 4>& corners, std::size_t size) {
  VertexId least = cell.vertex[corners[0]];
  for (std::size_t k = 1; k < size; ++k) least = std::min(least, cell.vertex[corners[k]]);
  CanonicalFace best;
  bool found = false;
  for (std::size_t k = 0; k < size; ++k) {
    if (cell.vertex[corners[k]] != least) continue;
    std::array<std::uint8_t, 4> order = corners;
    const FaceKey key = list_from(cell, corners[k], order, size);
    if (found && best.key <= key) continue;
    best = {key, order};
    found = true;
  }
  return best;
}

bool has_repeated_vertex(const Cell& cell, std::size_t corners) {
  for (std::size_t i = 0; i < corners; ++i) {
    for (std::size_t j = i + 1; j < corners; ++j) {
      if (cell.vertex[i] == cell.vertex[j] && cell.offset[i][j] == kIdentity) return true;
    }
  }
  return false;
}

std::vector<FaceKey> distinct_faces(const Complex& complex, std::size_t size) {
  std::vector<FaceKey> keys;
  for (const Cell& cell : complex.cells) {
    for (unsigned mask = 0; mask < (1U << complex.corners); ++mask) {
      std::array<std::uint8_t, 4> corners{};
      std::size_t n = 0;
      bool repeated = false;
      for (std::uint8_t i = 0; i < complex.corners; ++i) {
        if ((mask >> i & 1U) == 0) continue;
        for (std::size_t k = 0; k < n; ++k) {
          repeated = repeated ||
                     (cell.vertex[corners[k]] == cell.vertex[i] && cell.offset[corners[k]][i] == kIdentity);
        }
        corners[n++] = i;
      }
      if (n == size && !repeated) keys.push_back(canonical_face(cell, corners, size).key);
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

std::vector<Occurrence> facet_occurrences(const Complex& complex) {
  std::vector<Occurrence> occurrences;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const Cell& cell = complex.cells[c];
    if (has_repeated_vertex(cell, complex.corners)) continue;
    for (std::uint8_t facet = 0; facet < complex.corners; ++facet) {
      std::array<std::uint8_t, 4> corners{};
      std::size_t n = 0;
      for (std::uint8_t i = 0; i < complex.corners; ++i) {
        if (i != facet) corners[n++] = i;
      }
      CanonicalFace face = canonical_face(cell, corners, n);
      face.corner[n] = facet;
      int parity = 1;
      for (std::size_t i = 0; i < complex.corners; ++i) {
        for (std::size_t j = i + 1; j < complex.corners; ++j) {
          if (face.corner[i] > face.corner[j]) parity = -parity;
        }
      }
      occurrences.push_back(
          {face.key, make_id<CellId>(c), facet, face.corner[0], static_cast<std::int8_t>(parity)});
    }
  }
  std::sort(occurrences.begin(), occurrences.end(), [](const Occurrence& a, const Occurrence& b) {
    return std::tie(a.key, a.cell, a.facet) < std::tie(b.key, b.cell, b.facet);
  });
  return occurrences;
}

}  // namespace flatdt::checker
