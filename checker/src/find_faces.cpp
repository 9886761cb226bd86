// All faces of a complex, sorted by their lists.
#include "faces.hpp"

#include <array>
#include <vector>

#include "face_lists.hpp"
namespace flatdt::checker {
namespace {

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
