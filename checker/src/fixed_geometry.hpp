// Determinants and the insphere test in integers of fixed width, with a floating-point stage before.
//
// Bounds: coordinates are below kFixedLimit = 2^61, so differences are below 2^62, as are the entries of the
// Gram matrix; every intermediate value fits its type for all such inputs.   Source: docs/soundness.md,
// section 5.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "complex.hpp"
#include "fixed.hpp"
#include "flatdt/checker/exact.hpp"
#include "wide.hpp"

namespace flatdt::checker {

/// A vertex of an insphere test: a lift of a vertex modulo H.
struct Lift {
  VertexId vertex;
  ElementId offset;
};

/// What may decide: floating point, which is certain or silent; integers; or the first that can.
enum class FixedStage { doubles, limbs, both };

class FixedGeometry {
 public:
  using Point = Vec<std::int64_t>;
  using Norm = Wide<3>;

  /// Nothing if some number does not fit; offsets that do not, or are not in the table yet, are left to the
  /// caller.
  /// `gram`: of the lattice coordinates, scaled to integers.
  [[nodiscard]] static std::optional<FixedGeometry> make(const Complex& complex, const Orbits& orbits,
                                                         const ElementTable& table, const Mat<Integer>& gram);

  [[nodiscard]] std::int64_t denominator() const { return denominator_; }
  [[nodiscard]] const Point& base(VertexId v) const { return base_[index(v)]; }

  /// denominator^d det[p_1 - p_0 .. p_d - p_0]; nothing if a lift does not fit.
  [[nodiscard]] std::optional<Wide<3>> determinant(const std::array<Lift, 4>& cell) const;

  /// Whether the last point is inside (positive), on or outside the circumsphere of the first d+1, which have
  /// this orientation; nothing if a lift does not fit, or the only stage allowed is silent.
  using Answer = std::optional<Sign>;
  [[nodiscard]] Answer insphere(const std::array<Lift, 5>& points, Sign orientation, FixedStage stage) const;

 private:
  FixedGeometry() = default;

  using Rows = std::array<Point, 4>;  ///< differences to the last point
  bool lift(const Lift& l, Point& out) const;
  template <std::size_t D>
  [[nodiscard]] Answer answer(const std::array<Lift, 5>& points, Sign orientation, FixedStage stage) const;
  template <std::size_t D>
  [[nodiscard]] Answer sign_by_doubles(const Rows& rows) const;
  template <std::size_t D>
  [[nodiscard]] Sign sign_by_limbs(const Rows& rows) const;
  [[nodiscard]] Norm squared_norm(const Point& v) const;

  std::size_t dimension_ = 0;
  std::int64_t denominator_ = 1;
  Mat<std::int64_t> gram_{};
  Mat<double> gram_double_{};
  Mat<double> gram_magnitude_{};               // absolute values
  std::vector<Point> base_;                    // by VertexId
  std::vector<std::optional<FixedMap>> maps_;  // by ElementId, on base lifts
};

}  // namespace flatdt::checker
