#include "flatdt/ref/subgroup.hpp"

namespace flatdt::ref {
namespace {

int floor_quotient(int a, int b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

std::int16_t narrow(int value) {
  if (value > 32767 || value < -32767)
    throw LimitReached("the covering is longer than 32767 lattice vectors");
  return static_cast<std::int16_t>(value);
}

}  // namespace

Subgroup Subgroup::whole(const GroupTable& table) {
  Subgroup h(Kind::whole, table);
  h.representatives_.push_back(Element{});
  for (std::size_t i = 0; i < 3; ++i) h.basis_[i][i] = 1;
  return h;
}

Subgroup Subgroup::of_cosets(const GroupTable& table, const std::vector<bool>& listed) {
  Subgroup h(Kind::cosets, table);
  h.listed_ = listed;
  h.representatives_.push_back(Element{});
  for (std::size_t i = 0; i < 3; ++i) h.basis_[i][i] = 1;
  for (int c = 0; c < table.cosets(); ++c) {
    if (listed[static_cast<std::size_t>(c)]) continue;
    h.representatives_.push_back(Element{{}, static_cast<std::uint16_t>(c)});
    break;
  }
  return h;
}

Subgroup Subgroup::sublattice(const GroupTable& table, const Sublattice& lattice) {
  Subgroup h(Kind::sublattice, table);
  const int d = table.dimension();
  for (std::size_t i = 0; i < 3; ++i) h.basis_[i][i] = 1;
  for (int j = 0; j < d; ++j)
    for (int i = 0; i < d; ++i) {
      const Rational& entry = lattice.basis(i, j);
      ensure(entry.is_integer() && (i >= j || entry.is_zero()),
             "a sublattice is a lower-triangular integral basis");
      if (entry.numerator().bits() > 15)
        throw LimitReached("the covering is longer than 32767 lattice vectors");
      h.basis_[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] =
          static_cast<int>(entry.numerator().to_long());
    }
  const int n0 = h.basis_[0][0], n1 = h.basis_[1][1], n2 = h.basis_[2][2];
  // Bounded by sheets = index * holonomy order, which cover.hpp limits.
  for (int c = 0; c < table.cosets(); ++c)
    for (int x = 0; x < n0; ++x)
      for (int y = 0; y < n1; ++y)
        for (int z = 0; z < n2; ++z)
          h.representatives_.push_back(
              Element{{narrow(x), narrow(y), narrow(z)}, static_cast<std::uint16_t>(c)});
  return h;
}

Subgroup::Split Subgroup::split(const Element& g) const {
  switch (kind_) {
    case Kind::whole:
      return {g, 0};
    case Kind::cosets:
      if (listed_[g.coset]) return {g, 0};
      return {table_->multiply(g, table_->inverse(representatives_[1])), 1};
    case Kind::sublattice:
      break;
  }
  std::array<int, 3> rest{g.t[0], g.t[1], g.t[2]};
  for (std::size_t j = 0; j < 3; ++j) {
    const int q = floor_quotient(rest[j], basis_[j][j]);
    for (std::size_t i = j; i < 3; ++i) rest[i] -= q * basis_[j][i];
  }
  const Element s{{narrow(g.t[0] - rest[0]), narrow(g.t[1] - rest[1]), narrow(g.t[2] - rest[2])}, 0};
  const int n0 = basis_[0][0], n1 = basis_[1][1], n2 = basis_[2][2];
  const int rep = ((static_cast<int>(g.coset) * n0 + rest[0]) * n1 + rest[1]) * n2 + rest[2];
  return {s, static_cast<std::uint32_t>(rep)};
}

}  // namespace flatdt::ref
