#include "geometry.hpp"

namespace flatdt::edits {

using ref::Rational;
using ref::Vector;
using Rows = std::vector<std::vector<Rational>>;

namespace {

/// By expansion along the rows from `row` on, in the columns of the mask.
Rational determinant(const Rows& rows, std::size_t row, unsigned columns) {
  Rational sum;
  bool minus = false;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    if ((columns >> j & 1U) == 0) continue;
    if (!rows[row][j].is_zero()) {
      const Rational term = row + 1 == rows.size()
                                ? rows[row][j]
                                : rows[row][j] * determinant(rows, row + 1, columns & ~(1U << j));
      if (minus)
        sum -= term;
      else
        sum += term;
    }
    minus = !minus;
  }
  return sum;
}

Rational determinant(const Rows& rows) {
  return determinant(rows, 0, (1U << rows.size()) - 1);
}

}  // namespace

Rational signed_volume(const std::vector<Vector>& cell) {
  Rows rows;
  for (std::size_t i = 1; i < cell.size(); ++i) {
    rows.emplace_back();
    for (int k = 0; k < cell[0].dimension(); ++k) rows.back().push_back(cell[i][k] - cell[0][k]);
  }
  return determinant(rows);
}

int orientation(const std::vector<Vector>& cell) {
  return static_cast<int>(signed_volume(cell).sign());
}

int in_ball(const ref::Matrix& gram, const std::vector<Vector>& cell, const Vector& q) {
  const int d = gram.dimension();
  Rows rows;
  for (const Vector& p : cell) {
    const Vector v = p - q;
    rows.emplace_back();
    for (int k = 0; k < d; ++k) rows.back().push_back(v[k]);
    rows.back().push_back(ref::squared_length(gram, v));
  }
  const int sign = static_cast<int>(determinant(rows).sign()) * orientation(cell);
  return d % 2 == 0 ? sign : -sign;
}

std::vector<Vector> replaced(std::vector<Vector> cell, std::size_t corner, const Vector& by) {
  cell[corner] = by;
  return cell;
}

}  // namespace flatdt::edits
