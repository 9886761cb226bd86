/// Affine maps x -> R x + t (Seitz symbol {R|t}) in the instance's affine coordinates.
#pragma once

#include <compare>
#include <string>

#include "flatdt/ref/linear.hpp"

namespace flatdt::ref {

struct Isometry {
  Matrix linear;
  Vector translation;

  static Isometry identity(int dimension) { return {Matrix::identity(dimension), Vector(dimension)}; }
  static Isometry translate(const Vector& t) { return {Matrix::identity(t.dimension()), t}; }

  [[nodiscard]] int dimension() const { return linear.dimension(); }
  [[nodiscard]] bool is_identity() const { return linear.is_identity() && translation.is_zero(); }
  [[nodiscard]] Isometry inverse() const;
  /// The augmented d x (d+1) matrix [R|t] row by row, as in the file formats.
  [[nodiscard]] std::string to_string() const;

  /// (g h) x = g (h x).
  friend Isometry operator*(const Isometry& g, const Isometry& h);
  friend Vector operator*(const Isometry& g, const Vector& x) { return g.linear * x + g.translation; }
  friend bool operator==(const Isometry& a, const Isometry& b) {
    return a.linear == b.linear && a.translation == b.translation;
  }
  /// By linear part, then translation, lexicographically.
  friend std::strong_ordering operator<=>(const Isometry& a, const Isometry& b) {
    const auto order = a.linear <=> b.linear;
    return order != std::strong_ordering::equal ? order : a.translation <=> b.translation;
  }
};

/// R^T G R = G: the map preserves the metric of the Gram matrix.
bool preserves_metric(const Matrix& linear, const Matrix& gram);

}  // namespace flatdt::ref
