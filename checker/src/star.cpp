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

namespace {

/// The side opposite to the k-th vertex: the lesser and the greater of its ends.
template <std::size_t D>
std::pair<std::uint32_t, std::uint32_t> ends(const Star::Simplex& simplex, std::size_t k) {
  if constexpr (D == 2) return {simplex.vertex[1 - k], simplex.vertex[1 - k]};
  const std::uint32_t a = simplex.vertex[k == 0 ? 1 : 0];
  const std::uint32_t b = simplex.vertex[k == 2 ? 1 : 2];
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

/// Few vertices modulo H have two lifts in one star.
inline std::uint32_t Star::number(VertexId star, const Lift& lift) {
  const auto next = static_cast<std::uint32_t>(lifts_.size());
  Seen& seen = seen_[index(lift.vertex)];
  if (seen.star != static_cast<std::uint32_t>(star)) {
    seen = {static_cast<std::uint32_t>(star), next};
  } else if (lifts_[seen.number].offset == lift.offset) {
    return seen.number;
  } else if (const std::uint32_t known = others_.insert(pair_key(lift.vertex, lift.offset), next);
             known != next) {
    return known;
  }
  lifts_.push_back(lift);
  return next;
}

template <std::size_t D>
void Star::add(VertexId vertex, std::uint32_t corner) {
  const Cell& cell = complex_.cells[corner >> 2];
  const Offsets& offsets = complex_.offsets(cell);
  const std::size_t base = corner & 3U;
  Simplex simplex{corner, {}};
  bool repeated = false;
  std::size_t k = 0;
  for (std::size_t j = 0; j <= D; ++j) {
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
  if (repeated) {
    flattened_.push_back(make_id<CellId>(corner >> 2));
  } else {
    simplices_.push_back(simplex);
  }
}

template <std::size_t D>
void Star::match_sides() {
  facets_.clear();
  large_.clear();
  const bool small = lifts_.size() <= kSmall;
  for (std::uint32_t t = 0; t < simplices_.size(); ++t) {
    for (std::uint32_t k = 0; k < D; ++k) {
      const auto [low, high] = ends<D>(simplices_[t], k);
      const auto next = static_cast<std::uint32_t>(facets_.size());
      std::uint32_t number = next;
      if (!small) {
        number = large_.insert(pair_key(low, high), next);
      } else if (const std::uint32_t known = small_[kSmall * low + high];  // or what an earlier star left
                 known < next && facets_[known].low == low && facets_[known].high == high) {
        number = known;
      } else {
        small_[kSmall * low + high] = static_cast<std::uint16_t>(next);
      }
      if (number == next) {
        facets_.push_back({low, high, {t, k}, {t, k}, 1});
      } else if (++facets_[number].occurrences == 2) {
        facets_[number].second = {t, k};
      }
    }
  }
}

template <std::size_t D>
void Star::load_in(VertexId vertex, const std::uint32_t* first, const std::uint32_t* last) {
  others_.clear();
  lifts_.clear();
  loops_.clear();
  simplices_.clear();
  flattened_.clear();
  constexpr std::ptrdiff_t kAhead = 8;  // the cells at a vertex lie apart: each is fetched before its turn
  for (; first != last; ++first) {
    if (last - first > kAhead) __builtin_prefetch(&complex_.cells[first[kAhead] >> 2]);
    add<D>(vertex, *first);
  }
  match_sides<D>();
}

void Star::load(VertexId vertex, const std::uint32_t* first, const std::uint32_t* last) {
  complex_.corners == 3 ? load_in<2>(vertex, first, last) : load_in<3>(vertex, first, last);
}

}  // namespace flatdt::checker
