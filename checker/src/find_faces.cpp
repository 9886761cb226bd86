// All faces of a complex, star by star: a face is found in the star of the base vertex of its list.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "faces.hpp"
#include "ranges.hpp"
#include "star.hpp"

namespace flatdt::checker {
namespace {

class FaceFinder {
 public:
  /// `corners`: how many there will be.
  FaceFinder(const Complex& complex, std::size_t corners) : complex_(complex), star_(complex) {
    faces_.pairs.reserve(corners / 2);  // if all facets are paired
  }

  /// Adds the faces whose lists have v as their base vertex.   Requires: the corners at v; ascending v.
  void add(VertexId v, const std::uint32_t* first, const std::uint32_t* last) {
    star_.load(v, first, last);
    faces_.flattened.insert(faces_.flattened.end(), star_.flattened().begin(), star_.flattened().end());
    add_edges(v);
    add_facets(v);
    if (!faces_.bad_link) {
      if (const char* reason = link_defect(star_, complex_.corners, components_)) {
        faces_.bad_link = {v, reason, distinct_cells(star_, complex_.corners), star_.lifts().size()};
      }
    }
  }

  [[nodiscard]] Faces faces() && { return std::move(faces_); }

 private:
  /// A facet whose list is (v, identity), x, y; in 2D without y, which is x then.
  struct Found {
    std::uint64_t vertices;  // of x and y, then their offsets: the order of the lists
    std::uint64_t offsets;
    std::uint32_t x;  // number of the lift
    std::uint32_t facet;
  };

  // An edge between different vertices is one lift in the star of the lesser one. A loop is two lifts in its
  // vertex's star, of inverse offsets.
  void add_edges(VertexId v) {
    ends_.clear();
    for (const Star::Lift& lift : star_.lifts()) {
      if (lift.vertex > v) ends_.push_back(pair_key(lift.vertex, lift.offset));
    }
    for (const ElementId loop : star_.loops()) ends_.push_back(pair_key(v, loop));
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      const Edge edge{static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(ends_[k] >> 32),
                      static_cast<std::uint32_t>(ends_[k])};
      if (k > 0 && faces_.edges.back().high == edge.high && !faces_.parallel[2]) {
        faces_.parallel[2] = Faces::Parallel{faces_.edges.back().key(), edge.key()};
      }
      faces_.edges.push_back(edge);
    }
  }

  void add_facets(VertexId v) {
    found_.clear();
    const std::vector<Star::Lift>& lifts = star_.lifts();
    for (std::uint32_t f = 0; f < star_.facets().size(); ++f) {
      std::uint32_t x = star_.facets()[f].low;
      std::uint32_t y = star_.facets()[f].high;
      if (std::pair(lifts[y].vertex, lifts[y].offset) < std::pair(lifts[x].vertex, lifts[x].offset)) {
        std::swap(x, y);
      }
      if (lifts[x].vertex < v || (lifts[x].vertex == v && !is_base(star_.facets()[f]))) continue;
      found_.push_back(
          {pair_key(lifts[x].vertex, lifts[y].vertex), pair_key(lifts[x].offset, lifts[y].offset), x, f});
    }
    std::sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) {
      return a.vertices != b.vertices ? a.vertices < b.vertices : a.offsets < b.offsets;
    });
    for (std::size_t k = 0; k < found_.size(); ++k) add_facet(v, k);
  }

  void add_facet(VertexId v, std::size_t k) {
    const Found& found = found_[k];
    if (complex_.corners == 4) {
      ++faces_.count[3];
      if (k > 0 && found_[k - 1].vertices == found.vertices && !faces_.parallel[3]) {
        faces_.parallel[3] = Faces::Parallel{key_of(v, found_[k - 1]), key_of(v, found)};
      }
    }
    const Star::Facet& facet = star_.facets()[found.facet];
    FacetPair pair{occurrence(found, facet.first), occurrence(found, facet.second)};
    if (pair.second.cell == pair.first.cell && pair.second.facet < pair.first.facet) {
      std::swap(pair.first, pair.second);
    }
    if (facet.occurrences != 2) {
      if (!faces_.odd) faces_.odd = Faces::Odd{pair.first, facet.occurrences};
      return;
    }
    faces_.pairs.push_back(pair);
    if (is_doubled(star_, facet)) faces_.repeated_cells.push_back(pair.second.cell);
  }

  /// Whether the star's vertex is the base of the facet's list, where several vertices have the same least
  /// number.
  [[nodiscard]] bool is_base(const Star::Facet& facet) const {
    const Star::Simplex& simplex = star_.simplices()[facet.first.simplex];
    const Occurrence o{make_id<CellId>(simplex.cell()), simplex.other(facet.first.k), 0, 0};
    return facet_corners(complex_, o)[0] == simplex.base();
  }

  [[nodiscard]] Occurrence occurrence(const Found& found, const Star::Side& side) const {
    const Star::Simplex& simplex = star_.simplices()[side.simplex];
    const std::size_t others = complex_.corners - 1;
    // From the corners in ascending order, the base moves to the front, the apex to the end, and the two of
    // the list between them may change places.
    const bool swapped = others == 3 && simplex.vertex[side.k == 0 ? 1 : 0] != found.x;
    const std::size_t transpositions = simplex.base() + (others - 1 - side.k) + (swapped ? 1 : 0);
    return {make_id<CellId>(simplex.cell()), simplex.other(side.k), simplex.base(),
            static_cast<std::int8_t>(transpositions % 2 == 0 ? 1 : -1)};
  }

  [[nodiscard]] static FaceKey key_of(VertexId v, const Found& found) {
    const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); };
    const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
    return {{static_cast<std::uint32_t>(v), high(found.vertices), low(found.vertices), kNone},
            {high(found.offsets), low(found.offsets), kNone}};
  }

  const Complex& complex_;
  Star star_;
  Faces faces_;
  std::vector<std::uint64_t> ends_;
  std::vector<Found> found_;
  UnionFind components_{0};
};

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Adds the faces of later vertices.
void append(Faces& faces, const Faces& more) {
  append(faces.edges, more.edges);
  append(faces.pairs, more.pairs);
  append(faces.repeated_cells, more.repeated_cells);
  if (!faces.odd) faces.odd = more.odd;
  if (!faces.bad_link) faces.bad_link = more.bad_link;
  faces.count[3] += more.count[3];
  for (std::size_t size = 2; size < faces.parallel.size(); ++size) {
    if (!faces.parallel[size]) faces.parallel[size] = more.parallel[size];
  }
  append(faces.flattened, more.flattened);
}

void sort_distinct(std::vector<CellId>& cells) {
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

/// Facets that are sides of cells with a repeated vertex as well occur more than twice.
void drop_sides_of_flattened_cells(const Complex& complex, Faces& faces) {
  if (faces.flattened.empty()) return;
  std::vector<FaceKey> sides;
  for (const CellId c : faces.flattened) {
    const Cell& cell = complex.cells[index(c)];
    for (std::uint8_t facet = 0; facet < complex.corners; ++facet) {
      const Corners corners = side_corners(complex, facet);
      if (repeats_vertex(cell, complex.offsets(cell), corners, complex.corners - 1)) continue;
      sides.push_back(key_of_facet(complex, {c, facet, 0, 0}));
    }
  }
  std::sort(sides.begin(), sides.end());
  std::erase_if(faces.pairs, [&](const FacetPair& pair) {
    return std::binary_search(sides.begin(), sides.end(), key_of_facet(complex, pair.first));
  });
}

}  // namespace

Faces find_faces(const Complex& complex, unsigned jobs) {
  const CornerLists lists = list_corners(complex);
  std::vector<Faces> parts(jobs);
  in_ranges(complex.vertices.size(), jobs, [&](unsigned r, std::size_t begin, std::size_t end) {
    FaceFinder finder(complex, lists.start[end] - lists.start[begin]);
    for (std::size_t v = begin; v < end; ++v) {
      finder.add(make_id<VertexId>(v), lists.corner.data() + lists.start[v],
                 lists.corner.data() + lists.start[v + 1]);
    }
    parts[r] = std::move(finder).faces();
  });
  Faces faces = std::move(parts.front());
  for (std::size_t r = 1; r < parts.size(); ++r) append(faces, parts[r]);
  sort_distinct(faces.repeated_cells);
  sort_distinct(faces.flattened);
  drop_sides_of_flattened_cells(complex, faces);
  faces.count[2] = faces.edges.size();
  faces.count[complex.corners] = complex.cells.size() - faces.repeated_cells.size();
  return faces;
}

}  // namespace flatdt::checker
