#include "flatdt/ref/isometry.hpp"

namespace flatdt::ref {

Isometry Isometry::inverse() const {
  const Matrix inverse_linear = linear.inverse();
  return {inverse_linear, -(inverse_linear * translation)};
}

std::string Isometry::to_string() const {
  std::string text;
  for (int i = 0; i < dimension(); ++i) {
    for (int j = 0; j < dimension(); ++j) text += (i + j > 0 ? " " : "") + linear(i, j).to_string();
    text += " " + translation[i].to_string();
  }
  return text;
}

Isometry operator*(const Isometry& g, const Isometry& h) {
  return {g.linear * h.linear, g.linear * h.translation + g.translation};
}

bool preserves_metric(const Matrix& linear, const Matrix& gram) {
  return linear.transpose() * gram * linear == gram;
}

}  // namespace flatdt::ref
