// The faces of all cells with a given number of vertices, sorted by their canonical lists: by the first
// vertex in a counting sort, and then within the faces of each first vertex.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "faces.hpp"

namespace flatdt::checker {

/// A face with N+1 vertices of a cell without the first vertex of its list: N vertices and N offsets, two to
/// a word, so that the order of the words is that of the lists.
template <std::size_t N>
struct Entry {
  std::array<std::uint64_t, N> word;
  Occurrence where;

  [[nodiscard]] std::uint32_t number(std::size_t k) const {
    return static_cast<std::uint32_t>(k % 2 == 0 ? word[k / 2] >> 32 : word[k / 2]);
  }
  [[nodiscard]] bool operator<(const Entry& e) const {
    for (std::size_t k = 0; k < N; ++k) {
      if (word[k] != e.word[k]) return word[k] < e.word[k];
    }
    return where.cell != e.where.cell ? where.cell < e.where.cell : where.facet < e.where.facet;
  }
  [[nodiscard]] bool same_face(const Entry& e) const {
    bool same = true;
    for (std::size_t k = 0; k < N; ++k) same = same && word[k] == e.word[k];
    return same;
  }
  [[nodiscard]] bool same_vertices(const Entry& e) const {
    for (std::size_t k = 0; k < N; ++k) {
      if (number(k) != e.number(k)) return false;
    }
    return true;
  }
};

/// Entries sorted by the first vertex of the list: those of vertex v are entries[start[v]..start[v+1]).
template <class E>
struct Buckets {
  std::vector<std::size_t> start;
  std::vector<E> entries;
};

/// The sets of `size` of the numbers below `all`, each ascending.
template <std::size_t All, std::size_t Size>
constexpr auto make_subsets() {
  constexpr std::size_t kCount = Size == 2 ? All * (All - 1) / 2 : Size == All ? 1 : All;
  std::array<Corners, kCount> subsets{};  // Corners are numbers of entries here, too
  std::size_t count = 0;
  for (unsigned mask = 0; mask < (1U << All); ++mask) {
    if (static_cast<std::size_t>(std::popcount(mask)) != Size) continue;
    std::size_t n = 0;
    for (std::uint8_t k = 0; k < All; ++k) {
      if ((mask >> k & 1U) != 0) subsets[count][n++] = k;
    }
    ++count;
  }
  return subsets;
}

/// The corners of a cell in the order of their vertices, two bits each; kTies if two have the same vertex
/// modulo H (no order of at least three corners has that code).
using OrderCode = std::uint8_t;
inline constexpr OrderCode kTies = 0;

template <std::size_t All>
OrderCode order_code(const Cell& cell) {
  // A vertex and its corner in one word; a sorting network, as the order cannot be predicted.
  std::array<std::uint64_t, 4> word{};
  for (std::size_t i = 0; i < All; ++i) word[i] = (static_cast<std::uint64_t>(cell.vertex[i]) << 2) | i;
  const auto exchange = [&](std::size_t i, std::size_t j) {
    const std::uint64_t low = std::min(word[i], word[j]);
    word[j] = std::max(word[i], word[j]);
    word[i] = low;
  };
  if constexpr (All == 4) {
    exchange(0, 1);
    exchange(2, 3);
    exchange(0, 2);
    exchange(1, 3);
    exchange(1, 2);
  } else {
    exchange(0, 1);
    exchange(1, 2);
    exchange(0, 1);
  }
  unsigned code = 0;
  for (std::size_t k = 0; k < All; ++k) {
    if (k > 0 && word[k] >> 2 == word[k - 1] >> 2) return kTies;
    code |= static_cast<unsigned>(word[k] & 3U) << (2 * k);
  }
  return static_cast<OrderCode>(code);
}

/// Of the corners in the order of their vertices.
template <std::size_t All>
std::vector<OrderCode> order_codes(const Complex& complex) {
  std::vector<OrderCode> codes;
  codes.reserve(complex.cells.size());
  for (const Cell& cell : complex.cells) codes.push_back(order_code<All>(cell));
  return codes;
}

/// Calls visit(c, corners in canonical order) for all faces with Size different vertices of all cells with
/// All corners; `whole`: not of cells with a repeated vertex.
template <std::size_t All, std::size_t Size, class Visit>
void for_each_face(const Complex& complex, const std::vector<OrderCode>& codes, bool whole, Visit visit) {
  static constexpr auto kSubsets = make_subsets<All, Size>();
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const unsigned code = codes[c];
    if (code != kTies) {  // lists have different vertices: their order is the canonical one
      for (const Corners& subset : kSubsets) {
        Corners corners{};
        for (std::size_t k = 0; k < Size; ++k) {
          corners[k] = static_cast<std::uint8_t>(code >> (2 * subset[k]) & 3U);
        }
        visit(c, corners);
      }
      continue;
    }
    const Cell& cell = complex.cells[c];
    const Offsets& offset = complex.offsets(cell);
    if (whole && repeats_vertex(cell, offset, {0, 1, 2, 3}, All)) continue;
    for (Corners corners : kSubsets) {
      if (repeats_vertex(cell, offset, corners, Size)) continue;
      make_canonical(cell, offset, corners, Size);
      visit(c, corners);
    }
  }
}

/// Makes an entry (c, corners in canonical order) of each face with Size vertices.
template <class E, std::size_t All, std::size_t Size, class Make>
Buckets<E> sorted_entries(const Complex& complex, const std::vector<OrderCode>& codes, bool whole,
                          Make make) {
  Buckets<E> buckets;
  std::vector<std::size_t>& start = buckets.start;
  start.resize(complex.vertices.size() + 1);
  for_each_face<All, Size>(complex, codes, whole, [&](std::size_t c, const Corners& corners) {
    ++start[index(complex.cells[c].vertex[corners[0]])];
  });
  std::size_t end = 0;
  for (std::size_t& s : start) end = s += end;  // now the ends
  buckets.entries.resize(end);
  for_each_face<All, Size>(complex, codes, whole, [&](std::size_t c, const Corners& corners) {
    buckets.entries[--start[index(complex.cells[c].vertex[corners[0]])]] = make(c, corners);
  });
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    std::sort(buckets.entries.begin() + static_cast<std::ptrdiff_t>(start[v]),
              buckets.entries.begin() + static_cast<std::ptrdiff_t>(start[v + 1]));
  }
  return buckets;
}

/// Calls visit(v, first, count) for each run of entries of one face.
template <class E, class Visit>
void for_each_run(const Buckets<E>& buckets, Visit visit) {
  for (std::size_t v = 0; v + 1 < buckets.start.size(); ++v) {
    for (std::size_t i = buckets.start[v], end = i; i < buckets.start[v + 1]; i = end) {
      while (end < buckets.start[v + 1] && buckets.entries[end].same_face(buckets.entries[i])) ++end;
      visit(v, &buckets.entries[i], end - i);
    }
  }
}

}  // namespace flatdt::checker
