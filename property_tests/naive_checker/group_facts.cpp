#include "naive_checker/group_facts.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace flatdt::naive {
namespace {

using oracle::composed;
using oracle::Group;
using oracle::identity;
using oracle::image;
using oracle::inverse;
using oracle::Lattice;
using oracle::Matrix;
using oracle::minus;
using oracle::plus;
using oracle::product;
using oracle::Seitz;
using oracle::transposed;
using oracle::Vector;

/// 1 + R + ... + R^(m-1), m the order of R.
Matrix sum_of_powers(const Matrix& linear, int dimension) {
  Matrix sum = identity(dimension);
  for (Matrix power = linear; power != identity(dimension); power = product(power, linear))
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = plus(sum[i], power[i]);
  return sum;
}

struct Entry {
  const char* name;
  int dimension;
  bool orientable;
  std::size_t holonomy;
  std::size_t rank;
  std::vector<Integer> torsion;
};

const std::vector<Entry>& manifolds() {
  static const std::vector<Entry> kManifolds = {
      {"torus", 2, true, 1, 2, {}},
      {"klein-bottle", 2, false, 2, 1, {2}},
      {"torocosm", 3, true, 1, 3, {}},
      {"dicosm", 3, true, 2, 1, {2, 2}},
      {"tricosm", 3, true, 3, 1, {3}},
      {"tetracosm", 3, true, 4, 1, {2}},
      {"hexacosm", 3, true, 6, 1, {}},
      {"didicosm", 3, true, 4, 0, {4, 4}},
      {"first-amphicosm", 3, false, 2, 2, {2}},
      {"second-amphicosm", 3, false, 2, 2, {}},
      {"first-amphidicosm", 3, false, 4, 1, {2, 2}},
      {"second-amphidicosm", 3, false, 4, 1, {4}},
  };
  return kManifolds;
}

}  // namespace

bool is_torsion_free(const Group& group) {
  // {R|t+l}^m = {1|N(t+l)} with N = 1 + R + ... + R^(m-1): some l makes it 1 iff N t is in N L.
  return std::none_of(group.cosets.begin() + 1, group.cosets.end(), [&](const Seitz& c) {
    const Matrix n = sum_of_powers(c.linear, group.dimension);
    Lattice images;
    for (const Vector& b : group.lattice.basis()) images.insert(image(n, b));
    return images.contains(image(n, c.translation));
  });
}

AbelianGroup first_homology(const Group& group) {
  // Generators e_1..e_d, a basis of L, and s_a, one for each linear part. Relations: s_a e_i s_a^-1 = R_a
  // e_i; s_a s_b = {1|v} s_ab; s_1 = 1. In additive writing.
  const auto d = static_cast<std::size_t>(group.dimension);
  Matrix rows;
  for (std::size_t i = 0; i < d; ++i) rows[i] = group.lattice.basis()[i];
  const Matrix to_coordinates = inverse(transposed(rows), group.dimension);
  const auto multiples = [&](const Vector& v) {
    Relation relation;
    const Vector n = image(to_coordinates, v);
    for (std::size_t i = 0; i < d; ++i) {
      if (n[i].get_den() != 1) throw std::logic_error("a translation outside the lattice");
      relation[i] = n[i].get_num();
    }
    return relation;
  };
  std::vector<Relation> relations{{{d, 1}}};
  for (std::size_t a = 0; a < group.cosets.size(); ++a) {
    for (std::size_t i = 0; i < d; ++i) {
      Relation moved = multiples(image(group.cosets[a].linear, rows[i]));
      moved[i] -= 1;
      relations.push_back(std::move(moved));
    }
    for (std::size_t b = 0; b < group.cosets.size(); ++b) {
      const Seitz ab = composed(group.cosets[a], group.cosets[b]);
      const auto c = std::find_if(group.cosets.begin(), group.cosets.end(),
                                  [&](const Seitz& s) { return s.linear == ab.linear; });
      Relation relation = multiples(minus(ab.translation, c->translation));
      relation[d + static_cast<std::size_t>(c - group.cosets.begin())] += 1;
      relation[d + a] -= 1;
      relation[d + b] -= 1;
      relations.push_back(std::move(relation));
    }
  }
  return quotient(d + group.cosets.size(), std::move(relations));
}

std::string manifold_name(const Group& group) {
  const AbelianGroup homology = first_homology(group);
  for (const Entry& m : manifolds())
    if (m.dimension == group.dimension && m.orientable == group.is_orientable() &&
        m.holonomy == group.cosets.size() && homology == AbelianGroup{m.rank, m.torsion})
      return m.name;
  throw std::logic_error("a torsion-free group that is none of the twelve");
}

}  // namespace flatdt::naive
