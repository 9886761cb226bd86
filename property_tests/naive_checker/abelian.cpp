#include "naive_checker/abelian.hpp"

#include <algorithm>
#include <utility>

namespace flatdt::naive {
namespace {

/// row -= factor * other, without zeros.
void subtract(Relation& row, const Integer& factor, const Relation& other) {
  for (const auto& [column, value] : other) {
    Integer& entry = row[column];
    entry -= factor * value;
    if (entry == 0) row.erase(column);
  }
}

void remove_trivial(std::vector<Relation>& relations) {
  for (Relation& row : relations) std::erase_if(row, [](const auto& entry) { return entry.second == 0; });
  std::erase_if(relations, [](const Relation& row) { return row.empty(); });
}

/// The position of an entry of least absolute value, in a shortest such row.
std::pair<std::size_t, std::size_t> least_entry(const std::vector<Relation>& relations) {
  std::pair<std::size_t, std::size_t> best{0, relations[0].begin()->first};
  const Integer* least = &relations[0].begin()->second;
  for (std::size_t i = 0; i < relations.size(); ++i) {
    for (const auto& [column, value] : relations[i]) {
      const int order = mpz_cmpabs(value.get_mpz_t(), least->get_mpz_t());
      if (order > 0 || (order == 0 && relations[i].size() >= relations[best.first].size())) continue;
      best = {i, column};
      least = &value;
    }
  }
  return best;
}

/// The orders of cyclic summands in the form in which each divides the next: Z/a + Z/b = Z/gcd + Z/lcm.
std::vector<Integer> divisor_chain(std::vector<Integer> orders) {
  for (std::size_t i = 0; i < orders.size(); ++i) {
    for (std::size_t j = i + 1; j < orders.size(); ++j) {
      const Integer common = gcd(orders[i], orders[j]);
      orders[j] = lcm(orders[i], orders[j]);
      orders[i] = common;
    }
  }
  std::erase_if(orders, [](const Integer& order) { return order == 1; });
  return orders;
}

}  // namespace

AbelianGroup quotient(std::size_t generators, std::vector<Relation> relations) {
  std::size_t used = 0;
  std::vector<Integer> orders;
  remove_trivial(relations);
  while (!relations.empty()) {
    const auto [i, column] = least_entry(relations);
    const Relation pivot_row = relations[i];
    const Integer pivot = pivot_row.at(column);
    bool clean = true;
    for (std::size_t k = 0; k < relations.size(); ++k) {
      if (k == i) continue;
      const auto entry = relations[k].find(column);
      if (entry == relations[k].end()) continue;
      subtract(relations[k], Integer(entry->second / pivot), pivot_row);
      clean = clean && !relations[k].contains(column);
    }
    if (clean) {
      // The generator `column` occurs in this relation alone: subtracting multiples of it from the other
      // generators changes no other relation.
      Relation rest;
      for (const auto& [c, value] : pivot_row)
        if (c != column && value % pivot != 0) rest[c] = value % pivot;
      if (rest.empty()) {
        ++used;
        orders.emplace_back(abs(pivot));
      } else {
        rest[column] = pivot;
      }
      relations[i] = std::move(rest);
    }
    remove_trivial(relations);
  }
  return {generators - used, divisor_chain(std::move(orders))};
}

}  // namespace flatdt::naive
