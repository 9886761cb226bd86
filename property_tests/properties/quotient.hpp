/// E^d/G from its definition, in catalogue coordinates and exact rationals: canonical points, the cells of a
/// triangulation file as points of E^d, and what they are modulo G.
/// Nothing here uses the reference's tables or orders; only its arithmetic and its catalogue.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "flatdt/ref/triangulation_format.hpp"
#include "specimen.hpp"

namespace flatdt::property_tests {

using ref::Isometry;
using ref::Matrix;
using ref::Rational;
using ref::Vector;
using testing::Specimen;

class Quotient {
 public:
  explicit Quotient(const Specimen& specimen);

  struct Canonical {
    Vector point;    // the lexicographic minimum of the orbit's points in [0,1)^d
    Isometry mover;  // mover * x = point; unique, as G acts freely
  };
  [[nodiscard]] Canonical canonical(const Vector& x) const;
  [[nodiscard]] const std::vector<Isometry>& cosets() const { return cosets_; }

 private:
  std::vector<Isometry> cosets_;
};

/// The vertices of one lift of a cell, catalogue coordinates, in the file's order.
using CellCorners = std::vector<Vector>;

/// The cells of a triangulation of `instance`, moved to catalogue coordinates.
std::vector<CellCorners> corners_of(const ref::Instance& instance, const ref::Triangulation& triangulation,
                                    const Isometry& to_catalogue);

/// Cells modulo G: of each class the lift with the canonical barycentre, vertices sorted, by barycentre.
/// (Cells of one triangulation have different barycentres.)
struct Folded {
  std::map<Vector, CellCorners> cells;
  /// Every class has the same number of given cells.
  bool evenly = true;
  std::size_t multiplicity = 0;
};
Folded fold(const Quotient& quotient, const std::vector<CellCorners>& cells);

/// A Delaunay polytope: everything on one empty sphere.
struct Polytope {
  Rational squared_radius;
  std::set<Vector> vertices;
  friend bool operator==(const Polytope&, const Polytope&) = default;
};
/// The Delaunay tessellation modulo G: cells with one circumcentre merged, by canonical centre. Two Delaunay
/// triangulations of one point set give the same tessellation, whatever their ties.
using Tessellation = std::map<Vector, Polytope>;
Tessellation tessellate(const Quotient& quotient, const Matrix& gram, const Folded& folded);
/// Some polytope is no simplex.
bool has_ties(const Tessellation& tessellation, int dimension);
/// Square of the diameter of the largest empty ball.
Rational squared_diameter(const Tessellation& tessellation);

/// The edges modulo G with their directions: from the canonical point to the head. Both directions of an edge
/// are listed.
using Skeleton = std::map<Vector, std::set<Vector>>;
Skeleton skeleton(const Quotient& quotient, const Folded& folded);
bool has_loop(const Quotient& quotient, const Skeleton& edges);
/// Two different edges modulo G with the same ends; two loops at one vertex count.
bool has_two_cycle(const Quotient& quotient, const Skeleton& edges);

}  // namespace flatdt::property_tests
