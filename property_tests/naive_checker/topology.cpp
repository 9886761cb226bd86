#include "naive_checker/topology.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace flatdt::naive {
namespace {

using oracle::image;
using oracle::Vector;

/// The number of classes of `nodes` under the pairs.
template <class Node>
std::size_t components(const std::set<Node>& nodes, const std::vector<std::pair<Node, Node>>& pairs) {
  std::map<Node, std::set<Node>> neighbours;
  for (const auto& [a, b] : pairs) {
    neighbours[a].insert(b);
    neighbours[b].insert(a);
  }
  std::set<Node> seen;
  std::size_t count = 0;
  for (const Node& start : nodes) {
    if (!seen.insert(start).second) continue;
    ++count;
    std::vector<Node> open{start};
    while (!open.empty()) {
      const Node at = open.back();
      open.pop_back();
      for (const Node& next : neighbours[at])
        if (seen.insert(next).second) open.push_back(next);
    }
  }
  return count;
}

/// A set of edges {a, b} with a < b forms exactly one cycle.
bool is_one_cycle(const std::set<Face>& edges) {
  std::set<Vector> nodes;
  std::map<Vector, int> degree;
  std::vector<std::pair<Vector, Vector>> pairs;
  for (const Face& e : edges) {
    nodes.insert(e.begin(), e.end());
    for (const Vector& v : e) ++degree[v];
    pairs.emplace_back(e[0], e[1]);
  }
  return std::all_of(degree.begin(), degree.end(), [](const auto& n) { return n.second == 2; }) &&
         components(nodes, pairs) == 1;
}

/// A set of triangles forms a connected closed surface of Euler number 2.
bool is_two_sphere(const std::set<Face>& triangles) {
  std::map<Face, int> edges;
  std::map<Vector, std::set<Face>> around;
  for (const Face& t : triangles) {
    for (std::size_t i = 0; i < t.size(); ++i) {
      Face opposite = t;
      opposite.erase(opposite.begin() + static_cast<std::ptrdiff_t>(i));
      ++edges[opposite];
      around[t[i]].insert(opposite);
    }
  }
  std::set<Vector> nodes;
  for (const auto& [v, link] : around) {
    if (!is_one_cycle(link)) return false;
    nodes.insert(v);
  }
  std::vector<std::pair<Vector, Vector>> pairs;
  for (const auto& [e, count] : edges) {
    if (count != 2) return false;
    pairs.emplace_back(e[0], e[1]);
  }
  return components(nodes, pairs) == 1 && nodes.size() + triangles.size() == edges.size() + 2;
}

/// The sign of the orientation that a facet, its points ascending, gets from the order of the cell's corners.
int induced_sign(const FaceComplex& complex, const Face& facet, const Occurrence& at) {
  std::vector<std::ptrdiff_t> order;
  for (const std::size_t j : at.corners) {
    const Vector x = image(at.mover, complex.cells[at.cell][j]);
    order.push_back(std::find(facet.begin(), facet.end(), x) - facet.begin());
  }
  std::size_t swaps = FaceComplex::apex(at);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) swaps += order[j] > order[i] ? 1U : 0U;
  return swaps % 2 == 0 ? 1 : -1;
}

/// The boundary of a face in terms of the faces one dimension lower, numbered as in their map.
/// A face and its image under H carry the same orientation: the order of points along the canonical face.
std::vector<Relation> boundaries(const FaceComplex& complex, std::size_t dimension) {
  std::map<Face, std::size_t> number;
  for (const auto& [face, occurrences] : complex.faces[dimension - 1]) number.emplace(face, number.size());
  // Each facet of the face's first occurrence is a facet of that cell, which was recorded with its own mover.
  std::map<std::pair<std::size_t, std::vector<std::size_t>>, std::pair<const Face*, const Occurrence*>>
      recorded;
  for (const auto& [face, occurrences] : complex.faces[dimension - 1])
    for (const Occurrence& o : occurrences) recorded[{o.cell, o.corners}] = {&face, &o};

  std::vector<Relation> result;
  for (const auto& [face, occurrences] : complex.faces[dimension]) {
    const Occurrence& at = occurrences.front();
    // The corners in the order of their points on the canonical face.
    std::vector<std::size_t> ordered = at.corners;
    std::sort(ordered.begin(), ordered.end(), [&](std::size_t a, std::size_t b) {
      return image(at.mover, complex.cells[at.cell][a]) < image(at.mover, complex.cells[at.cell][b]);
    });
    Relation boundary;
    for (std::size_t i = 0; i < ordered.size(); ++i) {
      std::vector<std::size_t> rest = ordered;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      std::vector<std::size_t> key = rest;
      std::sort(key.begin(), key.end());
      const auto& [side, o] = recorded.at({at.cell, key});
      std::size_t swaps = i;
      for (std::size_t a = 0; a < rest.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
          if (image(o->mover, complex.cells[at.cell][rest[b]]) >
              image(o->mover, complex.cells[at.cell][rest[a]]))
            ++swaps;
      boundary[number.at(*side)] += swaps % 2 == 0 ? 1 : -1;
    }
    result.push_back(std::move(boundary));
  }
  return result;
}

}  // namespace

bool links_are_spheres(const FaceComplex& complex) {
  for (const auto& [vertex, occurrences] : complex.faces[0]) {
    std::set<Face> link;
    for (const Occurrence& o : occurrences) {
      Face opposite;
      for (std::size_t j = 0; j < complex.corners(); ++j)
        if (j != o.corners[0]) opposite.push_back(image(o.mover, complex.cells[o.cell][j]));
      std::sort(opposite.begin(), opposite.end());
      link.insert(std::move(opposite));
    }
    if (complex.dimension == 2 ? !is_one_cycle(link) : !is_two_sphere(link)) return false;
  }
  return true;
}

bool is_connected(const FaceComplex& complex) {
  std::set<std::size_t> nodes;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) nodes.insert(c);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [facet, occurrences] : complex.facets())
    for (const Occurrence& o : occurrences) pairs.emplace_back(occurrences.front().cell, o.cell);
  return components(nodes, pairs) <= 1;
}

long euler_number(const FaceComplex& complex) {
  long sum = 0;
  for (std::size_t k = 0; k < complex.corners(); ++k)
    sum += (k % 2 == 0 ? 1 : -1) * static_cast<long>(complex.faces[k].size());
  return sum;
}

bool is_orientable(const FaceComplex& complex) {
  // The sheets (cell, sign) of the double cover: orientable iff no cell's two sheets are connected.
  using Sheet = std::pair<std::size_t, int>;
  std::map<Sheet, std::vector<Sheet>> glued;
  for (const auto& [facet, occurrences] : complex.facets()) {
    const Occurrence& a = occurrences[0];
    const Occurrence& b = occurrences[1];
    const int same = -induced_sign(complex, facet, a) * induced_sign(complex, facet, b);
    for (const int sign : {1, -1}) {
      glued[{a.cell, sign}].emplace_back(b.cell, same * sign);
      glued[{b.cell, same * sign}].emplace_back(a.cell, sign);
    }
  }
  std::map<std::size_t, int> sign_of;
  for (std::size_t start = 0; start < complex.cells.size(); ++start) {
    if (!sign_of.emplace(start, 1).second) continue;
    std::vector<Sheet> open{{start, 1}};
    while (!open.empty()) {
      const Sheet at = open.back();
      open.pop_back();
      for (const auto& [cell, sign] : glued[at]) {
        const auto [known, is_new] = sign_of.emplace(cell, sign);
        if (is_new) open.emplace_back(cell, sign);
        if (known->second != sign) return false;
      }
    }
  }
  return true;
}

AbelianGroup first_homology(const FaceComplex& complex) {
  // Z^edges / im = H_1 + im(boundary of edges), the latter free of rank vertices - rank(coker).
  AbelianGroup result = quotient(complex.faces[1].size(), boundaries(complex, 2));
  const AbelianGroup rest = quotient(complex.faces[0].size(), boundaries(complex, 1));
  result.rank -= complex.faces[0].size() - rest.rank;
  return result;
}

}  // namespace flatdt::naive
