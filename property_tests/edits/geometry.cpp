#include "geometry.hpp"

namespace flatdt::edits {

using ref::Rational;
using ref::Vector;
using Rows = std::vector<std::vector<Rational>>;

namespace {

/// By expansion along the first row.
Rational determinant(const Rows& rows) {
  if (rows.size() == 1) return rows[0][0];
  Rational sum;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    if (rows[0][j].is_zero()) continue;
    Rows minor;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      minor.push_back(rows[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(j));
    }
    const Rational term = rows[0][j] * determinant(minor);
    if (j % 2 == 0)
      sum += term;
    else
      sum -= term;
  }
  return sum;
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
