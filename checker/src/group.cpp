#include "group.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "flatdt/checker/errors.hpp"
#include "linear.hpp"

namespace flatdt::checker {
namespace {

bool is_integral(const Vec<Rational>& v) {
  return v[0].get_den() == 1 && v[1].get_den() == 1 && v[2].get_den() == 1;
}

Vec<Integer> numerators(const Vec<Rational>& v) {
  return {v[0].get_num(), v[1].get_num(), v[2].get_num()};
}

void reduce_mod_1(Vec<Rational>& v) {
  for (Rational& x : v) {
    Integer floor;
    mpz_fdiv_q(floor.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    x -= floor;
  }
}

std::size_t order_of(const Group& group, std::size_t r) {
  std::size_t order = 1;
  for (std::size_t power = r; power != 0; power = group.product[power][r]) ++order;
  return order;
}

void fill_tables(Group& group) {
  const std::size_t n = group.order();
  const int d = group.dimension;
  group.product.assign(n, std::vector<std::uint8_t>(n));
  group.cocycle.assign(n, std::vector<Vec<Integer>>(n));
  group.inverse.assign(n, 0);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      const Mat<Integer> linear = multiply(d, group.linear[a], group.linear[b]);
      std::size_t r = 0;
      while (r < n && group.linear[r] != linear) ++r;
      if (r == n) throw InternalError("the point group is not closed");
      Vec<Rational> t = add(multiply(d, group.linear[a], group.translation[b]), group.translation[a]);
      t = subtract(t, group.translation[r]);
      if (!is_integral(t)) throw InternalError("the lattice misses a translation");
      group.product[a][b] = static_cast<std::uint8_t>(r);
      group.cocycle[a][b] = numerators(t);
      if (r == 0) group.inverse[a] = static_cast<std::uint8_t>(b);
    }
  }
}

}  // namespace

Group make_group(const Crystal& crystal) {
  Group group;
  const int d = group.dimension = crystal.dimension;
  group.basis = crystal.lattice.basis();
  group.basis_inverse = inverse(d, group.basis);
  for (const Seitz& outer : crystal.representatives) {
    Seitz g = change_basis(d, outer, group.basis, group.basis_inverse);
    reduce_mod_1(g.translation);
    Mat<Integer> linear;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_integral(g.linear[i])) throw InternalError("a linear part does not keep the lattice");
      linear[i] = numerators(g.linear[i]);
    }
    group.linear.push_back(linear);
    group.reversing.push_back(determinant(d, linear) < 0);
    group.translation.push_back(g.translation);
    group.representative.push_back(change_basis(d, g, group.basis_inverse, group.basis));
  }
  fill_tables(group);
  return group;
}

std::optional<Element> Group::locate(const Seitz& g) const {
  for (std::size_t r = 0; r < order(); ++r) {
    if (representative[r].linear != g.linear) continue;
    const Vec<Rational> shift =
        checker::multiply(dimension, basis_inverse, subtract(g.translation, representative[r].translation));
    if (!is_integral(shift)) return std::nullopt;
    return Element{static_cast<std::uint8_t>(r), numerators(shift)};
  }
  return std::nullopt;
}

// {I|l} s_a {I|m} s_b = {I | l + R_a m} s_a s_b.
Element Group::multiply(const Element& a, const Element& b) const {
  Vec<Integer> shift = checker::multiply(dimension, linear[a.rotation], b.shift);
  shift = add(add(shift, a.shift), cocycle[a.rotation][b.rotation]);
  return {product[a.rotation][b.rotation], shift};
}

// s_a^-1 = {I | -cocycle[a'][a]} s_a' with a' = inverse[a], and (r,l)^-1 = s_r^-1 {I|-l}.
Element Group::invert(const Element& a) const {
  const std::uint8_t r = inverse[a.rotation];
  const Vec<Integer> shift = add(cocycle[r][a.rotation], checker::multiply(dimension, linear[r], a.shift));
  return {r, subtract(Vec<Integer>{}, shift)};
}

Seitz Group::lattice_seitz(const Element& a) const {
  Seitz g;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) g.linear[i][j] = linear[a.rotation][i][j];
    g.translation[i] = translation[a.rotation][i] + a.shift[i];
  }
  return g;
}

Seitz Group::outer_seitz(const Element& a) const {
  return change_basis(dimension, lattice_seitz(a), basis_inverse, basis);
}

std::optional<TorsionElement> find_torsion(const Group& group) {
  const int d = group.dimension;
  const auto n = static_cast<std::size_t>(d);
  for (std::size_t r = 1; r < group.order(); ++r) {
    Rows rows(n, std::vector<Integer>(2 * n));  // I - R beside I
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) rows[i][j] = (i == j ? 1 : 0) - group.linear[r][i][j];
      rows[i][n + i] = 1;
    }
    const std::vector<Integer> diagonal = diagonalise(rows, n);
    Mat<Rational> u;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) u[i][j] = rows[i][n + j];
    }
    Vec<Rational> shift = multiply(d, u, group.translation[r]);  // becomes U l
    for (std::size_t i = 0; i < n; ++i) shift[i] = diagonal[i] == 0 ? Rational(-shift[i]) : Rational(0);
    if (!is_integral(shift)) continue;
    const Element g{static_cast<std::uint8_t>(r), numerators(multiply(d, inverse(d, u), shift))};
    // An element of finite order fixes the barycentre of every orbit, here of that of the origin.
    const Seitz outer = group.outer_seitz(g);
    const std::size_t order = order_of(group, r);
    Vec<Rational> image;
    Vec<Rational> sum;
    for (std::size_t k = 0; k < order; ++k) {
      image = apply(d, outer, image);
      sum = add(sum, image);
    }
    for (Rational& x : sum) x /= static_cast<unsigned long>(order);
    if (apply(d, outer, sum) != sum) throw InternalError("a torsion element does not fix its point");
    return TorsionElement{outer, sum, order};
  }
  return std::nullopt;
}

bool is_orientable(const Group& group) {
  return std::none_of(group.reversing.begin(), group.reversing.end(), [](bool reverses) { return reverses; });
}

std::string holonomy_name(const Group& group) {
  const std::size_t n = group.order();
  for (std::size_t r = 0; r < n; ++r) {
    if (order_of(group, r) == n) return n == 1 ? "1" : "Z" + std::to_string(n);
  }
  return n == 4 ? "Z2xZ2" : "order-" + std::to_string(n);
}

// Generators: e_1..e_d, then s_0..s_{n-1}. Relations: s_0 = 0; s_a e_i s_a^-1 = R_a e_i; s_a s_b = c(a,b)
// s_ab.
AbelianGroup first_homology(const Group& group) {
  const auto d = static_cast<std::size_t>(group.dimension);
  const std::size_t n = group.order();
  Rows relations(1, std::vector<Integer>(d + n));
  relations[0][d] = 1;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t i = 0; i < d; ++i) {
      auto& row = relations.emplace_back(d + n);
      for (std::size_t k = 0; k < d; ++k) row[k] = group.linear[a][k][i] - (k == i ? 1 : 0);
    }
    for (std::size_t b = 0; b < n; ++b) {
      auto& row = relations.emplace_back(d + n);
      for (std::size_t k = 0; k < d; ++k) row[k] = -group.cocycle[a][b][k];
      row[d + a] += 1;
      row[d + b] += 1;
      row[d + group.product[a][b]] -= 1;
    }
  }
  return abelian_group(d + n, std::move(relations));
}

}  // namespace flatdt::checker
