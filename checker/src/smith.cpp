#include "smith.hpp"

#include <algorithm>
#include <utility>

namespace flatdt::checker {
namespace {

/// Moves an entry of least absolute value of the block [k..) x [k..width) to (k, k); false if the block is
/// zero.
bool bring_pivot(Rows& rows, std::size_t k, std::size_t width) {
  std::size_t best_row = rows.size();
  std::size_t best_column = 0;
  for (std::size_t i = k; i < rows.size(); ++i) {
    for (std::size_t j = k; j < width; ++j) {
      if (rows[i][j] == 0) continue;
      if (best_row == rows.size() ||
          mpz_cmpabs(rows[i][j].get_mpz_t(), rows[best_row][best_column].get_mpz_t()) < 0) {
        best_row = i;
        best_column = j;
      }
    }
  }
  if (best_row == rows.size()) return false;
  std::swap(rows[k], rows[best_row]);
  for (auto& row : rows) std::swap(row[k], row[best_column]);
  return true;
}

/// Subtracts multiples of row k and column k; true when both are zero outside (k, k).
bool eliminate(Rows& rows, std::size_t k, std::size_t width) {
  bool clean = true;
  for (std::size_t i = k + 1; i < rows.size(); ++i) {
    const Integer q = rows[i][k] / rows[k][k];
    if (q != 0) {
      for (std::size_t j = k; j < rows[i].size(); ++j) rows[i][j] -= q * rows[k][j];
    }
    clean = clean && rows[i][k] == 0;
  }
  for (std::size_t j = k + 1; j < width; ++j) {
    const Integer q = rows[k][j] / rows[k][k];
    if (q != 0) {
      for (std::size_t i = k; i < rows.size(); ++i) rows[i][j] -= q * rows[i][k];
    }
    clean = clean && rows[k][j] == 0;
  }
  return clean;
}

}  // namespace

std::vector<Integer> diagonalise(Rows& rows, std::size_t width) {
  std::vector<Integer> diagonal;
  // Each repetition of eliminate lowers the least absolute value of the block, so it ends.
  for (std::size_t k = 0; k < std::min(rows.size(), width) && bring_pivot(rows, k, width); ++k) {
    while (!eliminate(rows, k, width)) bring_pivot(rows, k, width);
    diagonal.emplace_back(abs(rows[k][k]));
  }
  diagonal.resize(std::min(rows.size(), width));
  return diagonal;
}

AbelianGroup abelian_group(std::size_t generators, Rows relations) {
  std::vector<Integer> factors = diagonalise(relations, generators);
  std::erase(factors, 0);
  AbelianGroup group;
  group.betti = generators - factors.size();
  std::erase(factors, 1);
  // Z/a + Z/b = Z/gcd(a,b) + Z/lcm(a,b) makes the chain of divisors.
  for (std::size_t i = 0; i < factors.size(); ++i) {
    for (std::size_t j = i + 1; j < factors.size(); ++j) {
      const Integer common = gcd(factors[i], factors[j]);
      factors[j] = factors[i] / common * factors[j];
      factors[i] = common;
    }
  }
  std::erase(factors, 1);
  group.torsion = std::move(factors);
  return group;
}

std::string to_string(const AbelianGroup& group) {
  std::string text;
  if (group.betti > 0) text = group.betti == 1 ? "Z" : "Z^" + std::to_string(group.betti);
  for (const Integer& t : group.torsion) text += (text.empty() ? "Z/" : "+Z/") + t.get_str();
  return text.empty() ? "0" : text;
}

}  // namespace flatdt::checker
