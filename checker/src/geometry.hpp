// Exact lifts, determinants and the insphere test, in lattice coordinates of G, in stages: machine integers
// of fixed width (with a floating-point stage of their own) where the numbers fit, else floating-point balls
// and then integers of any size.
//
// In the last stage all coordinates of one evaluation are integers over one common denominator; temporaries
// are kept between calls (measured for such determinants: 1-2 us, against 27 us with mpq). The Gram matrix is
// scaled to integers.
// Threads: several may call orientation() and insphere() at once; on numbers of any size they take turns.
#pragma once

#include <array>
#include <mutex>
#include <optional>
#include <vector>

#include "ball.hpp"
#include "complex.hpp"
#include "fixed_geometry.hpp"
#include "flatdt/checker/check.hpp"
#include "flatdt/checker/exact.hpp"
#include "volume_sum.hpp"

namespace flatdt::checker {

class Geometry {
 public:
  /// `metric` in the instance's coordinates.
  Geometry(const Complex& complex, const Orbits& orbits, const ElementTable& table,
           const Mat<Rational>& metric, const Stages& stages = {});

  /// The sign of det[p_1 - p_0 .. p_d - p_0] of the normalised cell (frame of its first vertex); its absolute
  /// value is added to the sum.
  [[nodiscard]] Sign orientation(const Cell& cell, VolumeSum& sum);
  /// A sum for `orientation`.
  [[nodiscard]] VolumeSum no_volume() const;

  /// Sign of insphere(cell; q), q = offset * (base lift of v), the cell moved by H until its corner `frame`
  /// is a base lift: positive iff q is strictly inside the circumsphere. Formula:  orientation * (-1)^d det
  /// of the d+1 rows (p_i - q, |p_i - q|^2), p_i the moved cell. Requires: orientation is the sign of the
  /// determinant of the moved cell, not zero. Law:      zero iff cospherical.   Stages: all that the
  /// constructor allowed; the same answer from each.
  [[nodiscard]] Sign insphere(const Cell& cell, std::size_t frame, Sign orientation, const Lift& q);
  /// The last stage alone.
  [[nodiscard]] Sign insphere_exact(const std::array<Lift, 5>& points, Sign orientation);
  /// The balls alone.   Requires: the stage of fixed width was not allowed, or the input does not fit it.
  [[nodiscard]] std::optional<Sign> insphere_balls(const std::array<Lift, 5>& points, Sign orientation);

  [[nodiscard]] const std::optional<FixedGeometry>& fixed() const { return fixed_; }

  /// The corners of the moved cell, and q at the end.
  [[nodiscard]] std::array<Lift, 5> lifts(const Cell& cell, std::size_t frame, const Lift& q) const;

  /// The point offset * (base lift of v), exactly, in lattice coordinates.
  [[nodiscard]] Vec<Rational> point(VertexId v, ElementId offset) const;

 private:
  using Point = Vec<Integer>;

  void make_bases(const Orbits& orbits);
  void make_balls(const Mat<Rational>& gram);
  void lift(const Lift& l, std::size_t slot);
  void bring_to_common_denominator(std::size_t count);
  void squared_norm(const Point& v, Integer& out);
  void determinant(const Cell& cell);
  [[nodiscard]] Vec<Ball> ball_lift(const Lift& l);

  const Complex& complex_;
  const ElementTable& table_;
  Stages stages_;
  int dimension_;
  Integer group_denominator_;               // common denominator of the translations
  std::vector<Vec<Integer>> translations_;  // times group_denominator_
  Mat<Integer> gram_;

  std::optional<FixedGeometry> fixed_;
  // Without it:
  std::vector<LatticePoint> base_;  // by VertexId; the denominator is a multiple of group_denominator_
  std::vector<Vec<Ball>> base_ball_;
  std::vector<Mat<Ball>> linear_ball_;
  std::vector<Vec<Ball>> translation_ball_;
  Mat<Ball> gram_ball_;

  std::mutex mutex_;             // for what follows, and translation_ball_
  std::array<Point, 5> points_;  // kept temporaries
  std::array<Integer, 5> denominators_;
  Point x_;
  Integer common_, factor_, determinant_, power_, a_, b_;
  std::array<Integer, 4> norms_;
};

}  // namespace flatdt::checker
