#include "flatdt/ref/linear.hpp"

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref {

bool Vector::is_zero() const {
  for (int i = 0; i < dimension_; ++i)
    if (!(*this)[i].is_zero()) return false;
  return true;
}

bool Vector::is_integral() const {
  for (int i = 0; i < dimension_; ++i)
    if (!(*this)[i].is_integer()) return false;
  return true;
}

std::string Vector::to_string() const {
  std::string text;
  for (int i = 0; i < dimension_; ++i) text += (i > 0 ? " " : "") + (*this)[i].to_string();
  return text;
}

Vector operator+(const Vector& a, const Vector& b) {
  Vector r(a.dimension_);
  for (int i = 0; i < a.dimension_; ++i) r[i] = a[i] + b[i];
  return r;
}

Vector operator-(const Vector& a, const Vector& b) {
  Vector r(a.dimension_);
  for (int i = 0; i < a.dimension_; ++i) r[i] = a[i] - b[i];
  return r;
}

Vector operator-(const Vector& a) {
  Vector r(a.dimension_);
  for (int i = 0; i < a.dimension_; ++i) r[i] = -a[i];
  return r;
}

Vector operator*(const Rational& s, const Vector& a) {
  Vector r(a.dimension_);
  for (int i = 0; i < a.dimension_; ++i) r[i] = s * a[i];
  return r;
}

bool operator==(const Vector& a, const Vector& b) {
  return (a <=> b) == std::strong_ordering::equal;
}

std::strong_ordering operator<=>(const Vector& a, const Vector& b) {
  if (a.dimension_ != b.dimension_) return a.dimension_ <=> b.dimension_;
  for (int i = 0; i < a.dimension_; ++i)
    if (const auto order = a[i] <=> b[i]; order != std::strong_ordering::equal) return order;
  return std::strong_ordering::equal;
}

Matrix Matrix::identity(int dimension) {
  Matrix m(dimension);
  for (int i = 0; i < dimension; ++i) m(i, i) = 1;
  return m;
}

Matrix Matrix::transpose() const {
  Matrix m(dimension_);
  for (int i = 0; i < dimension_; ++i)
    for (int j = 0; j < dimension_; ++j) m(i, j) = (*this)(j, i);
  return m;
}

Rational Matrix::determinant() const {
  const Matrix& a = *this;
  if (dimension_ == 1) return a(0, 0);
  if (dimension_ == 2) return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) -
         a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
         a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
}

Matrix Matrix::inverse() const {
  const Rational det = determinant();
  if (det.is_zero()) throw InvalidInput("the matrix " + to_string() + " is singular");
  const Matrix& a = *this;
  Matrix m(dimension_);
  if (dimension_ == 1) {
    m(0, 0) = Rational(1) / det;
  } else if (dimension_ == 2) {
    m(0, 0) = a(1, 1) / det;
    m(0, 1) = -a(0, 1) / det;
    m(1, 0) = -a(1, 0) / det;
    m(1, 1) = a(0, 0) / det;
  } else {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const int r0 = (j + 1) % 3, r1 = (j + 2) % 3, c0 = (i + 1) % 3, c1 = (i + 2) % 3;
        m(i, j) = (a(r0, c0) * a(r1, c1) - a(r0, c1) * a(r1, c0)) / det;
      }
    }
  }
  return m;
}

Vector Matrix::column(int j) const {
  Vector v(dimension_);
  for (int i = 0; i < dimension_; ++i) v[i] = (*this)(i, j);
  return v;
}

void Matrix::set_column(int j, const Vector& v) {
  for (int i = 0; i < dimension_; ++i) (*this)(i, j) = v[i];
}

bool Matrix::is_integral() const {
  for (int i = 0; i < dimension_; ++i)
    for (int j = 0; j < dimension_; ++j)
      if (!(*this)(i, j).is_integer()) return false;
  return true;
}

bool Matrix::is_identity() const {
  return *this == identity(dimension_);
}

std::string Matrix::to_string() const {
  std::string text;
  for (int i = 0; i < dimension_; ++i)
    for (int j = 0; j < dimension_; ++j) text += (i + j > 0 ? " " : "") + (*this)(i, j).to_string();
  return text;
}

Matrix operator+(const Matrix& a, const Matrix& b) {
  Matrix m(a.dimension_);
  for (int i = 0; i < a.dimension_; ++i)
    for (int j = 0; j < a.dimension_; ++j) m(i, j) = a(i, j) + b(i, j);
  return m;
}

Matrix operator-(const Matrix& a, const Matrix& b) {
  Matrix m(a.dimension_);
  for (int i = 0; i < a.dimension_; ++i)
    for (int j = 0; j < a.dimension_; ++j) m(i, j) = a(i, j) - b(i, j);
  return m;
}

Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix m(a.dimension_);
  for (int i = 0; i < a.dimension_; ++i)
    for (int j = 0; j < a.dimension_; ++j)
      for (int k = 0; k < a.dimension_; ++k)
        if (!a(i, k).is_zero() && !b(k, j).is_zero()) m(i, j) += a(i, k) * b(k, j);
  return m;
}

Vector operator*(const Matrix& a, const Vector& v) {
  Vector r(a.dimension_);
  for (int i = 0; i < a.dimension_; ++i)
    for (int k = 0; k < a.dimension_; ++k)
      if (!a(i, k).is_zero()) r[i] += a(i, k) * v[k];
  return r;
}

Matrix operator*(const Rational& s, const Matrix& a) {
  Matrix m(a.dimension_);
  for (int i = 0; i < a.dimension_; ++i)
    for (int j = 0; j < a.dimension_; ++j) m(i, j) = s * a(i, j);
  return m;
}

bool operator==(const Matrix& a, const Matrix& b) {
  return (a <=> b) == std::strong_ordering::equal;
}

std::strong_ordering operator<=>(const Matrix& a, const Matrix& b) {
  if (a.dimension_ != b.dimension_) return a.dimension_ <=> b.dimension_;
  for (int i = 0; i < a.dimension_; ++i)
    for (int j = 0; j < a.dimension_; ++j)
      if (const auto order = a(i, j) <=> b(i, j); order != std::strong_ordering::equal) return order;
  return std::strong_ordering::equal;
}

Rational inner_product(const Matrix& gram, const Vector& u, const Vector& v) {
  Rational sum;
  const Vector gv = gram * v;
  for (int i = 0; i < u.dimension(); ++i) sum += u[i] * gv[i];
  return sum;
}

Rational squared_length(const Matrix& gram, const Vector& v) {
  return inner_product(gram, v, v);
}

bool is_positive_definite(const Matrix& gram) {
  for (int k = 1; k <= gram.dimension(); ++k) {
    Matrix minor(k);
    for (int i = 0; i < k; ++i)
      for (int j = 0; j < k; ++j) minor(i, j) = gram(i, j);
    if (minor.determinant().sign() != Sign::positive) return false;
  }
  return true;
}

}  // namespace flatdt::ref
