/// The Delaunay graph of an instance modulo its group, with which of its edges are there whatever the ties.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "flatdt/ref/group_analysis.hpp"
#include "flatdt/ref/instance.hpp"
#include "flatdt/ref/triangulation_format.hpp"

namespace flatdt::campaign {

/// A lift of a vertex: element * points[point].
struct Lift {
  std::uint32_t point;
  ref::Isometry element;
};

/// An edge modulo the group: from points[point] to a place; of the two ways to write it the lesser.
using EdgeKey = std::pair<std::uint32_t, ref::Vector>;

class DelaunayGraph {
 public:
  /// Requires: the triangulation is that of the instance (or of a cover of it).
  DelaunayGraph(const ref::Instance& instance, const ref::GroupAnalysis& analysis,
                const ref::Triangulation& triangulation);

  [[nodiscard]] bool is_member(const ref::Isometry& element) const;
  /// Requires: members, of different places.
  [[nodiscard]] EdgeKey key(const Lift& a, const Lift& b) const;
  /// Is there an empty ball with both ends on its boundary?
  [[nodiscard]] bool may_be_edge(const EdgeKey& edge) const;
  /// The edges whose Voronoi facets have positive area, each with the squared width of its facet: in the
  /// plane its length; in space the greatest distance of its vertices from its longest diagonal.
  [[nodiscard]] const std::map<EdgeKey, ref::Rational>& strong_edges() const { return strong_; }

 private:
  struct Ball {
    std::vector<Lift> vertices;
    ref::Vector centre;
  };
  using CellKey = std::vector<std::pair<std::uint32_t, ref::Vector>>;
  [[nodiscard]] CellKey cell_key(const std::vector<Lift>& lifts,
                                 const std::vector<ref::Vector>& places) const;
  [[nodiscard]] Lift representative(const Lift& lift) const;
  [[nodiscard]] ref::Vector place(const Lift& lift) const {
    return lift.element * instance_.points[lift.point];
  }
  [[nodiscard]] ref::Vector circumcentre(const std::vector<ref::Vector>& vertices) const;
  /// Requires: at least d vertices of a facet.
  [[nodiscard]] ref::Rational squared_width(const std::set<ref::Vector>& vertices) const;
  void find_representatives();
  void find_balls(const ref::Triangulation& triangulation);
  void find_strong_edges();

  const ref::Instance& instance_;
  const ref::GroupAnalysis& analysis_;
  ref::Matrix lattice_inverse_;
  std::vector<Lift> representatives_;     // of each point: the first of its orbit, and the element to it
  std::vector<std::vector<Ball>> balls_;  // of each first point: the cells around it
  std::set<EdgeKey> edges_;               // of the triangulation: with one choice at ties
  std::map<EdgeKey, ref::Rational> strong_;
};

}  // namespace flatdt::campaign
