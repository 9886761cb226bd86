/// Exact vectors and square matrices of dimension 2 or 3.
/// Shapes: a Vector has d coordinates, a Matrix is d x d, row by row; unused entries of the fixed arrays are
/// 0.
#pragma once

#include <array>
#include <compare>
#include <string>

#include "flatdt/ref/exact.hpp"

namespace flatdt::ref {

inline constexpr int kMaxDimension = 3;

/// A column vector.
class Vector {
 public:
  explicit Vector(int dimension) : dimension_(dimension) {}
  [[nodiscard]] int dimension() const { return dimension_; }
  Rational& operator[](int i) { return x_[static_cast<std::size_t>(i)]; }
  const Rational& operator[](int i) const { return x_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] bool is_zero() const;
  [[nodiscard]] bool is_integral() const;
  /// Coordinates separated by blanks, as in the file formats.
  [[nodiscard]] std::string to_string() const;

  friend Vector operator+(const Vector& a, const Vector& b);
  friend Vector operator-(const Vector& a, const Vector& b);
  friend Vector operator-(const Vector& a);
  friend Vector operator*(const Rational& s, const Vector& a);
  friend bool operator==(const Vector& a, const Vector& b);
  /// Lexicographic.
  friend std::strong_ordering operator<=>(const Vector& a, const Vector& b);

 private:
  int dimension_;
  std::array<Rational, kMaxDimension> x_;
};

/// A square matrix.
class Matrix {
 public:
  explicit Matrix(int dimension) : dimension_(dimension) {}
  static Matrix identity(int dimension);
  [[nodiscard]] int dimension() const { return dimension_; }
  Rational& operator()(int row, int column) { return a_[entry(row, column)]; }
  const Rational& operator()(int row, int column) const { return a_[entry(row, column)]; }
  [[nodiscard]] Matrix transpose() const;
  [[nodiscard]] Rational determinant() const;
  /// Throws InvalidInput if the matrix is singular.
  [[nodiscard]] Matrix inverse() const;
  [[nodiscard]] Vector column(int j) const;
  void set_column(int j, const Vector& v);
  [[nodiscard]] bool is_integral() const;
  [[nodiscard]] bool is_identity() const;
  /// Entries row by row, separated by blanks.
  [[nodiscard]] std::string to_string() const;

  friend Matrix operator+(const Matrix& a, const Matrix& b);
  friend Matrix operator-(const Matrix& a, const Matrix& b);
  friend Matrix operator*(const Matrix& a, const Matrix& b);
  friend Vector operator*(const Matrix& a, const Vector& v);
  friend Matrix operator*(const Rational& s, const Matrix& a);
  friend bool operator==(const Matrix& a, const Matrix& b);
  /// Lexicographic, row by row.
  friend std::strong_ordering operator<=>(const Matrix& a, const Matrix& b);

 private:
  static std::size_t entry(int row, int column) {
    return static_cast<std::size_t>(row) * kMaxDimension + static_cast<std::size_t>(column);
  }
  int dimension_;
  std::array<Rational, std::size_t{kMaxDimension} * kMaxDimension> a_;
};

/// u^T gram v: the inner product in Gram units.
Rational inner_product(const Matrix& gram, const Vector& u, const Vector& v);
/// v^T gram v: the squared length in Gram units.
Rational squared_length(const Matrix& gram, const Vector& v);
/// All leading principal minors are positive (Sylvester). Requires: gram symmetric.
bool is_positive_definite(const Matrix& gram);

}  // namespace flatdt::ref
