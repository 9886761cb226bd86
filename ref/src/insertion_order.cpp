#include "flatdt/ref/insertion_order.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "split_mix.hpp"

namespace flatdt::ref {
namespace {

constexpr std::size_t kGrowth = 8;       // of the number of points from round to round
constexpr std::size_t kFirstRound = 64;  // below, order does not matter

/// The position along Hilbert's curve of a point of a grid of 2^bits steps along each of d axes.
/// From the coarsest bit to the finest, the curve of a subcube is that of the cube reflected or with two axes
/// exchanged; undoing that axis by axis leaves a Gray code of the position.
std::uint64_t hilbert_position(std::array<std::uint32_t, 3> x, std::size_t d, unsigned bits) {
  for (std::uint32_t bit = 1U << (bits - 1); bit > 1; bit >>= 1U) {
    const std::uint32_t below = bit - 1;
    for (std::size_t i = 0; i < d; ++i) {
      if ((x[i] & bit) != 0) {
        x[0] ^= below;
      } else {
        const std::uint32_t exchanged = (x[0] ^ x[i]) & below;
        x[0] ^= exchanged;
        x[i] ^= exchanged;
      }
    }
  }
  for (std::size_t i = 1; i < d; ++i) x[i] ^= x[i - 1];
  std::uint32_t parity = 0;
  for (std::uint32_t bit = 1U << (bits - 1); bit > 1; bit >>= 1U)
    if ((x[d - 1] & bit) != 0) parity ^= bit - 1;
  for (std::size_t i = 0; i < d; ++i) x[i] ^= parity;
  std::uint64_t position = 0;
  for (unsigned b = bits; b-- > 0;)
    for (std::size_t i = 0; i < d; ++i) position = position << 1U | (x[i] >> b & 1U);
  return position;
}

/// Along the curve, in a box as long along each axis as the parallelepiped of the lattice.
void set_positions(const Frame& frame, const std::vector<Site>& sites,
                   std::vector<std::pair<std::uint64_t, SiteId>>& order) {
  constexpr unsigned kBits = 20;  // 60 bits in space
  const auto d = static_cast<std::size_t>(frame.dimension);
  std::array<double, 3> scale{};
  double longest = 0;
  for (std::size_t i = 0; i < d; ++i) {
    const auto k = static_cast<int>(i);
    scale[i] = std::sqrt(frame.gram(k, k).to_double());
    longest = std::max(longest, scale[i]);
  }
  // Of a metric beyond the range of doubles nothing is known; any order is right.
  for (double& s : scale) s = longest > 0 && std::isfinite(longest) ? s / longest : 1;
  for (auto& [position, site] : order) {
    const std::array<double, 3> at = sites[index_of(site)].approximate();
    std::array<std::uint32_t, 3> x{};
    for (std::size_t i = 0; i < d; ++i)
      x[i] = std::min(static_cast<std::uint32_t>(at[i] * scale[i] * (1U << kBits)), (1U << kBits) - 1);
    position = hilbert_position(x, d, kBits);
  }
}

}  // namespace

std::vector<SiteId> batch_order(const Frame& frame, const std::vector<Site>& sites, std::uint64_t seed) {
  // A block of so many bytes has a mapping of its own (with glibc), which is given back at the end; a smaller
  // one could leave a hole in the heap that stays resident below what is allocated next. Costs addresses
  // only.
  constexpr std::size_t kOwnMapping = std::size_t{1} << 25U, kMany = std::size_t{1} << 16U;
  std::vector<std::pair<std::uint64_t, SiteId>> order;
  if (sites.size() >= kMany) order.reserve(std::max(sites.size(), kOwnMapping / sizeof order[0] + 1));
  order.resize(sites.size());
  for (std::size_t n = 0; n < sites.size(); ++n) order[n].second = SiteId{static_cast<std::uint32_t>(n)};
  if (sites.size() > kFirstRound) set_positions(frame, sites, order);
  SplitMix64 random(seed);
  for (std::size_t n = order.size(); n > 1; --n) std::swap(order[n - 1], order[random.next() % n]);
  for (std::size_t end = order.size(); end > kFirstRound;) {
    const std::size_t begin = end / kGrowth;
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
              order.begin() + static_cast<std::ptrdiff_t>(end));
    end = begin;
  }
  std::vector<SiteId> result;
  result.reserve(order.size());
  for (const auto& [position, site] : order) result.push_back(site);
  return result;
}

}  // namespace flatdt::ref
