#include "faces.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace flatdt::checker {
namespace {

/// A face with N+1 vertices of a cell without the first vertex of its list: N vertices and N offsets, two to a
/// word, so that the order of the words is that of the lists.
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
constexpr OrderCode kTies = 0;

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

bool repeats_vertex(const Cell& cell, const Offsets& offset, const Corners& corners, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (cell.vertex[corners[k]] == cell.vertex[corners[i]] &&
          offset[corners[k]][corners[i]] == kIdentity) {
        return true;
      }
    }
  }
  return false;
}

/// Calls visit(c, corners in canonical order) for all faces with Size different vertices of all cells with All
/// corners; `whole`: not of cells with a repeated vertex.
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
Buckets<E> sorted_entries(const Complex& complex, const std::vector<OrderCode>& codes, bool whole, Make make) {
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

int parity_of(const Corners& corners, std::size_t size) {
  unsigned inversions = 0;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i + 1; j < size; ++j) inversions += corners[i] > corners[j] ? 1 : 0;
  }
  return inversions % 2 == 0 ? 1 : -1;
}

template <std::size_t N>
Entry<N> make_entry(const Complex& complex, std::size_t c, const Corners& corners) {
  const Cell& cell = complex.cells[c];
  const std::array<ElementId, 4>& offset = complex.offsets(cell)[corners[0]];
  std::array<std::uint32_t, 2 * N> numbers{};
  for (std::size_t k = 0; k < N; ++k) {
    numbers[k] = static_cast<std::uint32_t>(cell.vertex[corners[k + 1]]);
    numbers[N + k] = static_cast<std::uint32_t>(offset[corners[k + 1]]);
  }
  Entry<N> entry{};
  for (std::size_t k = 0; k < N; ++k) entry.word[k] = pair_key(numbers[2 * k], numbers[2 * k + 1]);
  entry.where.cell = make_id<CellId>(c);
  return entry;
}

template <std::size_t N>
FaceKey key_of(std::size_t first, const Entry<N>& entry) {
  FaceKey key;
  key.vertex[0] = static_cast<std::uint32_t>(first);
  for (std::size_t k = 0; k < N; ++k) {
    key.vertex[k + 1] = entry.number(k);
    key.offset[k] = entry.number(N + k);
  }
  return key;
}

/// Counts faces with N+1 vertices and notes the first parallel ones, as they come in the order of their
/// lists.
template <std::size_t N>
class Census {
 public:
  explicit Census(Faces& faces) : faces_(faces) {}

  void add(std::size_t v, const Entry<N>& entry) {
    ++faces_.count[N + 1];
    const bool parallel = last_ != nullptr && last_vertex_ == v && last_->same_vertices(entry);
    if (parallel && !faces_.parallel[N + 1]) {
      faces_.parallel[N + 1] = Faces::Parallel{key_of(v, *last_), key_of(v, entry)};
    }
    last_ = &entry;
    last_vertex_ = v;
  }

 private:
  Faces& faces_;
  const Entry<N>* last_ = nullptr;
  std::size_t last_vertex_ = 0;
};

template <std::size_t All>
void find_edges(const Complex& complex, const std::vector<OrderCode>& codes, Faces& faces) {
  struct End {
    std::uint64_t key;
    [[nodiscard]] bool operator<(const End& e) const { return key < e.key; }
    [[nodiscard]] bool same_face(const End& e) const { return key == e.key; }
  };
  const auto make = [&](std::size_t c, const Corners& corners) {
    const Cell& cell = complex.cells[c];
    return End{pair_key(cell.vertex[corners[1]], complex.offsets(cell)[corners[0]][corners[1]])};
  };
  const auto ends = sorted_entries<End, All, 2>(complex, codes, false, make);
  for_each_run(ends, [&](std::size_t v, const End* end, std::size_t) {
    const Edge edge{static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(end->key >> 32),
                    static_cast<std::uint32_t>(end->key)};
    if (!faces.parallel[2] && !faces.edges.empty() && faces.edges.back().low == edge.low &&
        faces.edges.back().high == edge.high) {
      faces.parallel[2] = Faces::Parallel{faces.edges.back().key(), edge.key()};
    }
    faces.edges.push_back(edge);
  });
  faces.count[2] = faces.edges.size();
}

template <std::size_t N>
void find_cells(const Complex& complex, const std::vector<OrderCode>& codes, Faces& faces) {
  const auto make = [&](std::size_t c, const Corners& corners) { return make_entry<N>(complex, c, corners); };
  const auto cells = sorted_entries<Entry<N>, N + 1, N + 1>(complex, codes, false, make);
  Census<N> census(faces);
  for_each_run(cells, [&](std::size_t v, const Entry<N>* cell, std::size_t) {
    census.add(v, *cell);
    faces.distinct_cells.push_back(cell->where.cell);
  });
}

template <std::size_t N>
void find_facets(const Complex& complex, const std::vector<OrderCode>& codes, Faces& faces) {
  const auto make = [&](std::size_t c, const Corners& corners) {
    Entry<N> entry = make_entry<N>(complex, c, corners);
    Corners with_apex = corners;
    std::size_t apex = (N + 1) * (N + 2) / 2;  // 0 + .. + (N + 1)
    for (std::size_t k = 0; k <= N; ++k) apex -= corners[k];
    with_apex[N + 1] = static_cast<std::uint8_t>(apex);
    entry.where.facet = with_apex[N + 1];
    entry.where.base = corners[0];
    entry.where.parity = static_cast<std::int8_t>(parity_of(with_apex, N + 2));
    return entry;
  };
  const auto facets = sorted_entries<Entry<N>, N + 2, N + 1>(complex, codes, true, make);
  faces.pairs.reserve(facets.entries.size() / 2);
  Census<N> census(faces);
  for_each_run(facets, [&](std::size_t v, const Entry<N>* facet, std::size_t occurrences) {
    if (N > 1) census.add(v, *facet);  // in the plane facets are edges
    if (occurrences == 2) {
      faces.pairs.push_back({facet[0].where, facet[1].where});
    } else if (!faces.odd) {
      faces.odd = Faces::Odd{facet->where, occurrences};
    }
  });
}

}  // namespace

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

bool has_repeated_vertex(const Complex& complex, const Cell& cell) {
  return repeats_vertex(cell, complex.offsets(cell), {0, 1, 2, 3}, complex.corners);
}

Corners facet_corners(const Complex& complex, const Occurrence& occurrence) {
  const Cell& cell = complex.cells[index(occurrence.cell)];
  Corners corners{};
  std::size_t n = 0;
  for (std::uint8_t i = 0; i < complex.corners; ++i) {
    if (i != occurrence.facet) corners[n++] = i;
  }
  make_canonical(cell, complex.offsets(cell), corners, n);
  return corners;
}

Faces find_faces(const Complex& complex) {
  Faces faces;
  if (complex.corners == 3) {
    const std::vector<OrderCode> codes = order_codes<3>(complex);
    find_edges<3>(complex, codes, faces);
    find_cells<2>(complex, codes, faces);
    find_facets<1>(complex, codes, faces);
  } else {
    const std::vector<OrderCode> codes = order_codes<4>(complex);
    find_edges<4>(complex, codes, faces);
    find_cells<3>(complex, codes, faces);
    find_facets<2>(complex, codes, faces);
  }
  return faces;
}

}  // namespace flatdt::checker
