#include "flatdt/ref/tie_order.hpp"

#include "flatdt/ref/wide_integer.hpp"

namespace flatdt::ref {
namespace {

/// Which cosets belong to the subgroup whose left order is used. The didicosm group contains the dicosm group
/// H = <Z^3, (-x+1/2, -y, z+1/2)> with index 2 (INSERTION, "Didicosm"): linear parts 1 and diag(-1,-1,1) in
/// catalogue coordinates.
std::vector<bool> first_half(const Frame& frame) {
  std::vector<bool> half(frame.cosets.size(), true);
  if (frame.entry->left_orderable) return half;
  Matrix screw = Matrix::identity(3);
  screw(0, 0) = -1;
  screw(1, 1) = -1;
  const Matrix from_catalogue = frame.to_catalogue.inverse();
  for (std::size_t c = 0; c < frame.cosets.size(); ++c) {
    const Matrix linear = frame.to_catalogue * frame.cosets[c].linear * from_catalogue;
    half[c] = linear.is_identity() || linear == screw;
  }
  return half;
}

Subgroup invariance(const GroupTable& table, const std::vector<bool>& half) {
  for (const bool in_half : half)
    if (!in_half) return Subgroup::of_cosets(table, half);
  return Subgroup::whole(table);
}

}  // namespace

TieOrder::TieOrder(const Frame& frame, const GroupTable& table)
    : table_(&table),
      invariance_group_(invariance(table, first_half(frame))),
      in_first_half_(first_half(frame)) {
  std::array<Matrix, 2> to_key{frame.to_catalogue, frame.to_catalogue};
  // g = h a: R_h^-1 t_h = R_a (R_g^-1 t_g) - t_a, and the constant t_a cancels within the half.
  if (!invariance_group_.is_whole()) {
    const Isometry a = table.isometry(invariance_group_.representative(1));
    to_key[1] = frame.to_catalogue * a.linear;
  }
  for (std::size_t half = 0; half < 2; ++half) {
    for (const int coordinate : frame.entry->left_order_coordinates) {
      std::array<Integer, 3> row;
      for (int j = 0; j < frame.dimension; ++j)
        row[static_cast<std::size_t>(j)] = to_key[half](coordinate, j).numerator();
      rows_[half].push_back(row);
    }
  }
  bool small = true;
  for (const auto& rows : rows_)
    for (const auto& row : rows)
      for (const Integer& entry : row) small = small && entry.bits() <= 31;
  for (std::size_t half = 0; small && half < 2; ++half)
    for (const auto& row : rows_[half])
      small_rows_[half].push_back({row[0].to_long(), row[1].to_long(), row[2].to_long()});
}

bool TieOrder::element_less(const Element& g, const Element& h) const {
  const bool first = in_first_half_[g.coset];
  if (first != in_first_half_[h.coset]) return first;
  const std::array<std::int64_t, 3> kg = table_->left_order_key(g);
  const std::array<std::int64_t, 3> kh = table_->left_order_key(h);
  // Keys are below 2^31: a few thousand times 2^15, the bound of an element's translations.
  for (const auto& row : small_rows_[first ? 0 : 1]) {
    Int128 difference = 0;
    for (std::size_t j = 0; j < 3; ++j) difference += static_cast<Int128>(row[j]) * (kg[j] - kh[j]);
    if (difference != 0) return difference < 0;
  }
  if (!small_rows_[first ? 0 : 1].empty()) return false;
  for (const std::array<Integer, 3>& row : rows_[first ? 0 : 1]) {
    Integer difference;
    for (std::size_t j = 0; j < 3; ++j) difference += row[j] * Integer(static_cast<long>(kg[j] - kh[j]));
    if (!difference.is_zero()) return difference.sign() == Sign::negative;
  }
  return false;
}

}  // namespace flatdt::ref
