// The star of one vertex modulo H after another: the cells at its base lift, by the lifts of their other
// vertices.
//
// Corner i of a cell c at the vertex v stands for the cell h_i^-1 c, which has v's base lift as its i-th
// vertex; the simplex opposite to it is a simplex of v's link, and the sides of that simplex stand for the
// facets of the cell at v. A side that lies in several simplices stands for one facet in H^-1-images of
// several cells.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "complex.hpp"
#include "id_map.hpp"
#include "union_find.hpp"

namespace flatdt::checker {

/// The corners of all cells by their vertices: those at v are corner[start[v]..start[v+1]), ascending. A
/// corner is 4 cell + i; FORMAT.md's limit of 10^9 cells leaves room for that.
struct CornerLists {
  std::vector<std::uint32_t> start;
  std::vector<std::uint32_t> corner;
};
[[nodiscard]] CornerLists list_corners(const Complex& complex);

class Star {
 public:
  /// A vertex of the link.
  struct Lift {
    VertexId vertex;
    ElementId offset;
  };
  /// The simplex of the link opposite to a corner. Its k-th vertex is that of the k-th other corner.
  struct Simplex {
    std::uint32_t corner;
    std::array<std::uint32_t, 3> vertex;  ///< numbers of lifts

    [[nodiscard]] std::size_t cell() const { return corner >> 2; }
    [[nodiscard]] std::uint8_t base() const { return static_cast<std::uint8_t>(corner & 3U); }
    /// The corner of the cell that the k-th vertex is at.
    [[nodiscard]] std::uint8_t other(std::size_t k) const {
      return static_cast<std::uint8_t>(k < base() ? k : k + 1);
    }
  };
  /// The side of a simplex opposite to its k-th vertex.
  struct Side {
    std::uint32_t simplex;
    std::uint32_t k;
  };
  /// A facet at the vertex: its one (2D) or two (3D) other vertices, and the sides that are equal to it.
  struct Facet {
    std::uint32_t low;  ///< numbers of lifts; the same in 2D
    std::uint32_t high;
    Side first;  ///< in the order of the cells
    Side second;
    std::uint32_t occurrences;
  };

  explicit Star(const Complex& complex) : complex_(complex), seen_(complex.vertices.size()) {}

  /// Requires: the corners at `vertex`; no earlier call had this vertex.
  /// Cost: expected linear in the corners.
  void load(VertexId vertex, const std::uint32_t* first, const std::uint32_t* last);

  /// The different lifts at the other ends of the edges at the vertex, its own among them for loops.
  [[nodiscard]] const std::vector<Lift>& lifts() const { return lifts_; }
  /// For each loop at each corner: the lesser of its two offsets.
  [[nodiscard]] const std::vector<ElementId>& loops() const { return loops_; }
  /// Of the cells without a repeated vertex.
  [[nodiscard]] const std::vector<Simplex>& simplices() const { return simplices_; }
  /// The cells with a repeated vertex, once for each of their corners here.
  [[nodiscard]] const std::vector<CellId>& flattened() const { return flattened_; }
  [[nodiscard]] const std::vector<Facet>& facets() const { return facets_; }
  [[nodiscard]] std::uint32_t apex(const Side& side) const { return simplices_[side.simplex].vertex[side.k]; }

 private:
  /// The first lift of a vertex modulo H that is seen in a star.
  struct Seen {
    std::uint32_t star = 0xFFFFFFFF;  // whose vertex
    std::uint32_t number = 0;
  };
  /// Stars with so many lifts have their facets in a table; these are fewer than 2^16.
  static constexpr std::size_t kSmall = 64;

  std::uint32_t number(VertexId star, const Lift& lift);
  template <std::size_t D>
  void load_in(VertexId vertex, const std::uint32_t* first, const std::uint32_t* last);
  template <std::size_t D>
  void add(VertexId vertex, std::uint32_t corner);
  template <std::size_t D>
  void match_sides();

  const Complex& complex_;
  std::vector<Seen> seen_;  // by VertexId
  IdMap others_;            // the lifts that are not in seen_
  std::vector<Lift> lifts_;
  std::vector<ElementId> loops_;
  std::vector<Simplex> simplices_;
  std::vector<CellId> flattened_;
  std::vector<Facet> facets_;
  std::array<std::uint16_t, kSmall * kSmall> small_{};  // by ends: the number of the last facet with them
  IdMap large_;                                         // the same for larger stars
};

/// Whether the two cells at a facet are one, which is listed twice: their apexes are one lift.
[[nodiscard]] bool is_doubled(const Star& star, const Star::Facet& facet);

/// Why the link of the star's vertex is no sphere, or null.   Requires: no cell has a repeated vertex.
/// Law: a link is a circle (2D) iff every vertex has two edges and all edges are connected across vertices; a
/// sphere (3D) iff every edge has two triangles, all triangles are connected across edges, and V - E + F = 2.
/// (Pulled apart at its vertices it is a connected closed surface, of Euler number at most 2; a vertex at
/// which that surface touches itself lowers the number. So 2 means a sphere that touches itself nowhere.)
/// `components` is memory to work in. Source: docs/soundness.md, section 6.
[[nodiscard]] const char* link_defect(const Star& star, std::size_t corners, UnionFind& components);

/// How many different cells are at the vertex.   Requires: every facet occurs twice, no cell has a repeated
/// vertex.
[[nodiscard]] std::size_t distinct_cells(const Star& star, std::size_t corners);

}  // namespace flatdt::checker
