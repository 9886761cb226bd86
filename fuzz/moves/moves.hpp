/// Geometric changes of a specimen. Each returns false, and may leave the specimen half changed, where it
/// does not apply: the caller works on a copy.
#pragma once

#include "../specimen/specimen.hpp"
#include "random.hpp"

namespace flatdt::fuzz {

/// A change of one kind or another, as the shape allows. Law: the result keeps the limits of specimens.
[[nodiscard]] bool move_anything(Specimen& specimen, Random& random, const Shape& shape);

/// Points: grids, midpoints of orbits, cospheres, circumcentres, screw axes and glide planes, 2^-k beside an
/// image of another point; added, removed, replaced by another representative of the orbit.
[[nodiscard]] bool move_point(Specimen& specimen, Random& random);
/// The metric: canonical, stretched, sheared, nearly degenerate, 2^-k beside itself.
[[nodiscard]] bool move_metric(Specimen& specimen, Random& random);
/// The group: another one, another basis and origin, other generators, a generator changed so that it may
/// generate no admissible group.
[[nodiscard]] bool move_group(Specimen& specimen, Random& random);
/// The triangulation: flips, splits, other lifts, wrong lifts, missing and doubled cells, other subgroups.
[[nodiscard]] bool move_cells(Specimen& specimen, Random& random);
/// The triangulation becomes that of the instance: of the cover that ref writes where that is small, or of
/// the manifold itself, simplicial or not.
[[nodiscard]] bool recompute_cells(Specimen& specimen, Random& random);
/// The query points.
[[nodiscard]] bool move_queries(Specimen& specimen, Random& random);

/// Parts of both: the points of one added to the other, or its metric, group or cells taken.
[[nodiscard]] bool cross(Specimen& specimen, const Specimen& other, Random& random, const Shape& shape);

/// A small rational as occurs in crystals, of either sign.
[[nodiscard]] ref::Rational simple_rational(Random& random);
/// 2^-k, k from 1 to 61, of either sign.
[[nodiscard]] ref::Rational tiny_rational(Random& random);
/// An element of the group, near the identity, in the specimen's own coordinates.
[[nodiscard]] ref::Isometry random_element(const Specimen& specimen, Random& random);
/// The vector in another dimension: cut off, or with zeros.
[[nodiscard]] ref::Vector in_dimension(const ref::Vector& v, int dimension);

}  // namespace flatdt::fuzz
