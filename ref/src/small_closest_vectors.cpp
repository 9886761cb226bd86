#include "small_closest_vectors.hpp"

#include <algorithm>

#include "wide_integer.hpp"

namespace flatdt::ref {
namespace {

using Coordinates = std::array<std::int64_t, 3>;

struct SmallProblem {
  std::size_t d = 0;
  std::array<Coordinates, 3> gram{};
  std::int64_t denominator = 1;
  Coordinates floors{};
  Coordinates rest{};  // denominator * (x - floors), in [0, denominator)

  /// n^T G v.
  [[nodiscard]] Int128 product(const Coordinates& n, const Coordinates& v) const {
    Int128 sum = 0;
    for (std::size_t i = 0; i < d; ++i) {
      if (n[i] == 0) continue;
      Int128 row = 0;
      for (std::size_t j = 0; j < d; ++j) row += static_cast<Int128>(gram[i][j]) * v[j];
      sum += n[i] > 0 ? row : -row;
    }
    return sum;
  }
};

std::optional<SmallProblem> small_problem(const Matrix& gram, const Vector& x) {
  SmallProblem result;
  result.d = static_cast<std::size_t>(gram.dimension());
  Integer scale = 1;
  Integer common = 1;
  for (int i = 0; i < gram.dimension(); ++i) {
    common = lcm(common, x[i].denominator());
    for (int j = 0; j < gram.dimension(); ++j) scale = lcm(scale, gram(i, j).denominator());
  }
  if (common.bits() > 61) return std::nullopt;
  std::size_t bits = 0;
  for (int i = 0; i < gram.dimension(); ++i)
    for (int j = 0; j < gram.dimension(); ++j) {
      const Integer entry = gram(i, j).numerator() * exact_div(scale, gram(i, j).denominator());
      bits = std::max(bits, entry.bits());
      if (bits > 62) return std::nullopt;
      result.gram[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = entry.to_long();
    }
  if (bits + common.bits() + 8 > 126) return std::nullopt;
  result.denominator = common.to_long();
  for (int i = 0; i < gram.dimension(); ++i) {
    const Integer numerator = x[i].numerator() * exact_div(common, x[i].denominator());
    const Integer floor = floor_div(numerator, common);
    if (floor.bits() > 61) return std::nullopt;
    const auto k = static_cast<std::size_t>(i);
    result.floors[k] = floor.to_long();
    result.rest[k] = (numerator - floor * common).to_long();
  }
  return result;
}

}  // namespace

std::optional<std::vector<std::array<std::int64_t, 3>>> small_closest_vectors(const Matrix& gram,
                                                                              const Vector& x) {
  const std::optional<SmallProblem> problem = small_problem(gram, x);
  if (!problem) return std::nullopt;
  const std::size_t d = problem->d;
  // Sums of proper subsets of the superbase: of unit vectors, and minus such sums.
  struct Relevant {
    Coordinates n;
    Int128 squared;  // denominator * <n,n>
  };
  std::vector<Relevant> relevant;
  for (unsigned subset = 1; subset < (1U << d); ++subset)
    for (const std::int64_t sign : {1, -1}) {
      Relevant r{};
      for (std::size_t i = 0; i < d; ++i) r.n[i] = (subset >> i & 1U) != 0 ? sign : 0;
      r.squared = problem->product(r.n, r.n) * problem->denominator;
      relevant.push_back(r);
    }
  // x - s for the closest s: from the fractional part by steepest descent.
  Coordinates difference = problem->rest;
  const auto moved = [&](Coordinates from, const Coordinates& n) {
    for (std::size_t i = 0; i < d; ++i) from[i] -= problem->denominator * n[i];
    return from;
  };
  for (;;) {
    const Relevant* best = nullptr;
    Int128 gain = 0;
    for (const Relevant& r : relevant) {
      const Int128 g = 2 * problem->product(r.n, difference) - r.squared;
      if (g <= gain) continue;
      gain = g;
      best = &r;
    }
    if (best == nullptr) break;
    difference = moved(difference, best->n);
  }
  std::vector<Coordinates> differences{difference};
  for (std::size_t i = 0; i < differences.size(); ++i)
    for (const Relevant& r : relevant) {
      if (2 * problem->product(r.n, differences[i]) != r.squared) continue;
      const Coordinates tie = moved(differences[i], r.n);
      if (std::find(differences.begin(), differences.end(), tie) == differences.end())
        differences.push_back(tie);
    }
  for (Coordinates& s : differences)
    for (std::size_t i = 0; i < d; ++i)
      s[i] = problem->floors[i] + (problem->rest[i] - s[i]) / problem->denominator;
  return differences;
}

}  // namespace flatdt::ref
