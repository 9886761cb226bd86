#include "small_closest_vectors.hpp"

#include <algorithm>
#include <bit>

namespace flatdt::ref {

std::optional<SmallClosestVectors> SmallClosestVectors::make(const Matrix& gram) {
  SmallClosestVectors result;
  result.dimension_ = static_cast<std::size_t>(gram.dimension());
  Integer scale = 1;
  for (int i = 0; i < gram.dimension(); ++i)
    for (int j = 0; j < gram.dimension(); ++j) scale = lcm(scale, gram(i, j).denominator());
  std::array<Coordinates, 3> integral{};
  for (int i = 0; i < gram.dimension(); ++i)
    for (int j = 0; j < gram.dimension(); ++j) {
      const Integer entry = gram(i, j).numerator() * exact_div(scale, gram(i, j).denominator());
      // Two bits more for the images: sums of three entries.
      if (entry.bits() > 60) return std::nullopt;
      result.bits_ = std::max(result.bits_, static_cast<int>(entry.bits()));
      integral[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = entry.to_long();
    }
  const std::size_t d = result.dimension_;
  // Sums of unit vectors, and their negatives, which contain minus the sum of all.
  for (unsigned subset = 1; subset < (1U << d); ++subset)
    for (const std::int64_t sign : {1, -1}) {
      Relevant r{};
      for (std::size_t i = 0; i < d; ++i) r.n[i] = (subset >> i & 1U) != 0 ? sign : 0;
      for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j) r.image[i] += integral[i][j] * r.n[j];
      for (std::size_t i = 0; i < d; ++i) r.squared += static_cast<Int128>(r.image[i]) * r.n[i];
      result.relevant_.push_back(r);
    }
  return result;
}

std::optional<std::vector<SmallClosestVectors::Coordinates>> SmallClosestVectors::operator()(
    const Coordinates& numerators, std::int64_t denominator) const {
  if (bits_ + std::bit_width(static_cast<std::uint64_t>(denominator)) + 8 > 126 ||
      std::bit_width(static_cast<std::uint64_t>(denominator)) > 60)
    return std::nullopt;
  const std::size_t d = dimension_;
  Coordinates floors{};
  Coordinates rest{};
  for (std::size_t i = 0; i < d; ++i) {
    floors[i] = numerators[i] / denominator;
    if (numerators[i] % denominator < 0) --floors[i];
    rest[i] = numerators[i] - floors[i] * denominator;
  }
  const auto product = [d](const Relevant& r, const Coordinates& v) {
    Int128 sum = 0;
    for (std::size_t i = 0; i < d; ++i) sum += static_cast<Int128>(r.image[i]) * v[i];
    return sum;
  };
  const auto moved = [d, denominator](Coordinates from, const Coordinates& n) {
    for (std::size_t i = 0; i < d; ++i) from[i] -= denominator * n[i];
    return from;
  };
  // x - s for the closest s, from the fractional part by steepest descent.
  Coordinates difference = rest;
  for (;;) {
    const Relevant* best = nullptr;
    Int128 gain = 0;
    for (const Relevant& r : relevant_) {
      const Int128 g = 2 * product(r, difference) - r.squared * denominator;
      if (g <= gain) continue;
      gain = g;
      best = &r;
    }
    if (best == nullptr) break;
    difference = moved(difference, best->n);
  }
  std::vector<Coordinates> found{difference};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Relevant& r : relevant_) {
      if (2 * product(r, found[i]) != r.squared * denominator) continue;
      const Coordinates tie = moved(found[i], r.n);
      if (std::find(found.begin(), found.end(), tie) == found.end()) found.push_back(tie);
    }
  for (Coordinates& s : found)
    for (std::size_t i = 0; i < d; ++i) s[i] = floors[i] + (rest[i] - s[i]) / denominator;
  return found;
}

}  // namespace flatdt::ref
