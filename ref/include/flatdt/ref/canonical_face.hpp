/// Canonical representatives of faces modulo a subgroup H, and of cells as sorted lists of orbit points.
/// A face is the H-orbit of a set of points of GP. Its key: for each vertex, multiply the whole face by the
/// element of H that makes this vertex's element the representative of its coset; take the least sorted list.
/// Law: H acts freely, so the minimum is attained for one multiplier only, and keys are equal iff the faces
/// are.
#pragma once

#include <algorithm>
#include <array>

#include "flatdt/ref/exact_predicates.hpp"
#include "flatdt/ref/subgroup.hpp"

namespace flatdt::ref {

/// A face with K vertices and the element n with n * face = key.
template <std::size_t K>
struct CanonicalFace {
  std::array<OrbitPoint, K> key;
  Element multiplier;
};

template <std::size_t K>
std::array<OrbitPoint, K> moved(const GroupTable& table, const Element& s, std::array<OrbitPoint, K> face) {
  for (OrbitPoint& p : face) p.g = table.multiply(s, p.g);
  return face;
}

template <std::size_t K>
CanonicalFace<K> canonical_face(const GroupTable& table, const Subgroup& subgroup,
                                const std::array<OrbitPoint, K>& face) {
  SiteId least = face[0].site;
  for (const OrbitPoint& p : face) least = std::min(least, p.site);
  CanonicalFace<K> best{};
  bool have = false;
  for (const OrbitPoint& p : face) {
    if (p.site != least) continue;  // a list that starts with the least site is the least
    const Element multiplier = table.inverse(subgroup.split(p.g).s);
    std::array<OrbitPoint, K> candidate = moved(table, multiplier, face);
    std::sort(candidate.begin(), candidate.end());
    if (!have || candidate < best.key) best = {candidate, multiplier};
    have = true;
  }
  return best;
}

}  // namespace flatdt::ref
