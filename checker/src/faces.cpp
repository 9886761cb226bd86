#include "faces.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace flatdt::checker {
namespace {

/// A face with N+1 vertices of a cell, the first vertex of its list apart.
template <std::size_t N>
struct Entry {
  std::array<std::uint32_t, N> vertex;
  std::array<std::uint32_t, N> offset;
  Occurrence where;

  [[nodiscard]] bool operator<(const Entry& e) const {
    if (vertex != e.vertex) return vertex < e.vertex;
    if (offset != e.offset) return offset < e.offset;
    return where.cell != e.where.cell ? where.cell < e.where.cell : where.facet < e.where.facet;
  }
  [[nodiscard]] bool same_face(const Entry& e) const { return vertex == e.vertex && offset == e.offset; }
};

/// Entries sorted by the first vertex of the list: those of vertex v are entries[start[v]..start[v+1]).
template <class E>
struct Buckets {
  std::vector<std::size_t> start;
  std::vector<E> entries;
};

int parity_of(const Corners& corners, std::size_t size) {
  int parity = 1;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i + 1; j < size; ++j) {
      if (corners[i] > corners[j]) parity = -parity;
    }
  }
  return parity;
}

/// Calls visit(c, corners in canonical order) for all faces with `size` different vertices of all cells.
template <class Visit>
void for_each_face(const Complex& complex, std::size_t size, Visit visit) {
  const std::size_t all = complex.corners;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const Cell& cell = complex.cells[c];
    Corners order{0, 1, 2, 3};
    for (std::size_t k = 1; k < all; ++k) {  // insertion sort
      for (std::size_t i = k; i > 0 && cell.vertex[order[i]] < cell.vertex[order[i - 1]]; --i) {
        std::swap(order[i], order[i - 1]);
      }
    }
    bool different = true;
    for (std::size_t k = 1; k < all; ++k) {
      different = different && cell.vertex[order[k]] != cell.vertex[order[k - 1]];
    }
    for (unsigned mask = 0; mask < (1U << all); ++mask) {
      if (static_cast<std::size_t>(std::popcount(mask)) != size) continue;
      Corners corners{};
      std::size_t n = 0;
      for (std::size_t k = 0; k < all; ++k) {
        if ((mask >> k & 1U) != 0) corners[n++] = order[k];
      }
      if (!different) {
        const Offsets& offset = complex.offsets(cell);
        bool repeated = false;
        for (std::size_t i = 0; i < n; ++i) {
          for (std::size_t k = 0; k < i; ++k) {
            repeated = repeated || (cell.vertex[corners[k]] == cell.vertex[corners[i]] &&
                                    offset[corners[k]][corners[i]] == kIdentity);
          }
        }
        if (repeated) continue;
        make_canonical(cell, offset, corners, n);
      }
      visit(c, corners);
    }
  }
}

/// Makes an entry (c, corners in canonical order) of each face with `size` vertices that `accept`s.
template <class E, class Accept, class Make>
Buckets<E> sorted_entries(const Complex& complex, std::size_t size, Accept accept, Make make) {
  Buckets<E> buckets;
  std::vector<std::size_t>& start = buckets.start;
  start.resize(complex.vertices.size() + 1);
  for_each_face(complex, size, [&](std::size_t c, const Corners& corners) {
    const Cell& cell = complex.cells[c];
    if (accept(cell)) ++start[index(cell.vertex[corners[0]])];
  });
  std::size_t end = 0;
  for (std::size_t& s : start) end = s += end;  // now the ends
  buckets.entries.resize(end);
  for_each_face(complex, size, [&](std::size_t c, const Corners& corners) {
    const Cell& cell = complex.cells[c];
    if (accept(cell)) buckets.entries[--start[index(cell.vertex[corners[0]])]] = make(c, corners);
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

template <std::size_t N>
Entry<N> make_entry(const Complex& complex, std::size_t c, const Corners& corners) {
  const Cell& cell = complex.cells[c];
  const Offsets& offset = complex.offsets(cell);
  Entry<N> entry{};
  for (std::size_t k = 0; k < N; ++k) {
    entry.vertex[k] = static_cast<std::uint32_t>(cell.vertex[corners[k + 1]]);
    entry.offset[k] = static_cast<std::uint32_t>(offset[corners[0]][corners[k + 1]]);
  }
  entry.where.cell = make_id<CellId>(c);
  return entry;
}

template <std::size_t N>
FaceKey key_of(std::size_t first, const Entry<N>& entry) {
  FaceKey key;
  key.vertex[0] = static_cast<std::uint32_t>(first);
  for (std::size_t k = 0; k < N; ++k) {
    key.vertex[k + 1] = entry.vertex[k];
    key.offset[k] = entry.offset[k];
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
    const bool parallel = last_ != nullptr && last_vertex_ == v && last_->vertex == entry.vertex;
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

void find_edges(const Complex& complex, Faces& faces) {
  struct End {
    std::uint64_t key;
    [[nodiscard]] bool operator<(const End& e) const { return key < e.key; }
    [[nodiscard]] bool same_face(const End& e) const { return key == e.key; }
  };
  const auto make = [&](std::size_t c, const Corners& corners) {
    const Cell& cell = complex.cells[c];
    return End{pair_key(cell.vertex[corners[1]], complex.offsets(cell)[corners[0]][corners[1]])};
  };
  const auto ends = sorted_entries<End>(complex, 2, [](const Cell&) { return true; }, make);
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
void find_cells(const Complex& complex, Faces& faces) {
  const auto make = [&](std::size_t c, const Corners& corners) { return make_entry<N>(complex, c, corners); };
  const auto cells = sorted_entries<Entry<N>>(complex, N + 1, [](const Cell&) { return true; }, make);
  Census<N> census(faces);
  for_each_run(cells, [&](std::size_t v, const Entry<N>* cell, std::size_t) {
    census.add(v, *cell);
    faces.distinct_cells.push_back(cell->where.cell);
  });
}

template <std::size_t N>
void find_facets(const Complex& complex, Faces& faces) {
  const auto accept = [&](const Cell& cell) { return !has_repeated_vertex(complex, cell); };
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
  const auto facets = sorted_entries<Entry<N>>(complex, N + 1, accept, make);
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
  for (std::size_t i = 0; i < complex.corners; ++i) {
    for (std::size_t j = i + 1; j < complex.corners; ++j) {
      if (cell.vertex[i] == cell.vertex[j] && complex.offsets(cell)[i][j] == kIdentity) return true;
    }
  }
  return false;
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
  find_edges(complex, faces);
  if (complex.corners == 3) {
    find_cells<2>(complex, faces);
    find_facets<1>(complex, faces);
  } else {
    find_cells<3>(complex, faces);
    find_facets<2>(complex, faces);
  }
  return faces;
}

}  // namespace flatdt::checker
