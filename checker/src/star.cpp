#include "star.hpp"

#include <algorithm>

namespace flatdt::checker {

CornerLists list_corners(const Complex& complex) {
  CornerLists lists;
  lists.start.resize(complex.vertices.size() + 1);
  for (const Cell& cell : complex.cells) {
    for (std::size_t i = 0; i < complex.corners; ++i) ++lists.start[index(cell.vertex[i])];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& s : lists.start) end = s += end;  // now the ends
  lists.corner.resize(end);
  for (std::size_t c = complex.cells.size(); c-- > 0;) {
    for (std::size_t i = complex.corners; i-- > 0;) {
      lists.corner[--lists.start[index(complex.cells[c].vertex[i])]] = static_cast<std::uint32_t>(4 * c + i);
    }
  }
  return lists;
}

/// The side opposite to the k-th vertex: the lesser and the greater of its ends.
inline std::pair<std::uint32_t, std::uint32_t> Star::ends(const Simplex& simplex, std::size_t k) const {
  if (sides_of_simplex_ == 2) return {simplex.vertex[1 - k], simplex.vertex[1 - k]};
  const std::uint32_t a = simplex.vertex[k == 0 ? 1 : 0];
  const std::uint32_t b = simplex.vertex[k == 2 ? 1 : 2];
  return {std::min(a, b), std::max(a, b)};
}

/// Few vertices modulo H have two lifts in one star.
inline std::uint32_t Star::number(VertexId star, const Lift& lift) {
  const auto next = static_cast<std::uint32_t>(lifts_.size());
  Seen& seen = seen_[index(lift.vertex)];
  if (seen.star != static_cast<std::uint32_t>(star)) {
    seen = {static_cast<std::uint32_t>(star), lift.offset, next};
  } else if (seen.offset == lift.offset) {
    return seen.number;
  } else if (const std::uint32_t known = others_.insert(pair_key(lift.vertex, lift.offset), next);
             known != next) {
    return known;
  }
  lifts_.push_back(lift);
  start_.push_back(0);
  return next;
}

inline void Star::add(VertexId vertex, std::uint32_t corner) {
  const Cell& cell = complex_.cells[corner >> 2];
  const Offsets& offsets = complex_.offsets(cell);
  const std::size_t base = corner & 3U;
  Simplex simplex{corner, {}};
  bool repeated = false;
  std::size_t k = 0;
  for (std::size_t j = 0; j < complex_.corners; ++j) {
    if (j == base) continue;
    const Lift lift{cell.vertex[j], offsets[base][j]};
    if (lift.vertex == vertex) {
      repeated = repeated || lift.offset == kIdentity;
      if (lift.offset == kIdentity) continue;
      loops_.push_back(std::min(lift.offset, offsets[j][base]));
    }
    const std::uint32_t n = number(vertex, lift);
    for (std::size_t i = 0; i < k; ++i) repeated = repeated || simplex.vertex[i] == n;
    simplex.vertex[k++] = n;
  }
  if (repeated) return;
  simplices_.push_back(simplex);
  for (k = 0; k < sides_of_simplex_; ++k) ++start_[ends(simplex, k).first];
}

void Star::load(VertexId vertex, const std::uint32_t* first, const std::uint32_t* last) {
  others_.clear();
  lifts_.clear();
  loops_.clear();
  simplices_.clear();
  start_.clear();
  constexpr std::ptrdiff_t kAhead =
      8;  // the cells at a vertex lie far apart: each is fetched before its turn
  for (; first != last; ++first) {
    if (last - first > kAhead) __builtin_prefetch(&complex_.cells[first[kAhead] >> 2]);
    add(vertex, *first);
  }
  sort_sides();
  match_sides();
}

/// By their low ends, in a counting sort that keeps the order of the simplices.
void Star::sort_sides() {
  std::uint32_t end = 0;
  for (std::uint32_t& s : start_) end = s += end;  // now the ends
  start_.push_back(end);
  sides_.resize(end);
  for (std::size_t t = simplices_.size(); t-- > 0;) {
    for (std::size_t k = sides_of_simplex_; k-- > 0;) {
      const auto [low, high] = ends(simplices_[t], k);
      sides_[--start_[low]] = {high, {static_cast<std::uint32_t>(t), static_cast<std::uint32_t>(k)}};
    }
  }
}

void Star::match_sides() {
  facets_.clear();
  latest_.assign(lifts_.size(), 0);
  for (std::uint32_t low = 0; low < lifts_.size(); ++low) {
    const std::size_t mine = facets_.size();  // the facets with this low end start here
    for (std::uint32_t i = start_[low]; i < start_[low + 1]; ++i) {
      const auto& [high, side] = sides_[i];
      std::uint32_t& latest = latest_[high];
      if (latest < mine || latest >= facets_.size() || facets_[latest].high != high) {
        latest = static_cast<std::uint32_t>(facets_.size());
        facets_.push_back({low, high, side, side, 1});
      } else if (++facets_[latest].occurrences == 2) {
        facets_[latest].second = side;
      }
    }
  }
}

}  // namespace flatdt::checker
