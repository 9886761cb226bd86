#include "small_world.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "metrics.hpp"
#include "require.hpp"
#include "specimen.hpp"

namespace flatdt::property_tests {
namespace {

using ref::Integer;
using ref::Rational;
using ref::Vector;

long floor_mod(long a, long b) {
  return (a % b + b) % b;
}

/// C(n, k) for k <= 4.
std::size_t binomial(std::size_t n, std::size_t k) {
  std::size_t value = 1;
  for (std::size_t i = 0; i < k; ++i) value = value * (n - i) / (i + 1);
  return n < k ? 0 : value;
}

/// The place of an ascending set among all sets of its size: sum of C(c_i, i + 1).
std::size_t rank_of(const SmallWorld::PointSet& set) {
  std::size_t rank = 0;
  for (std::size_t i = 0; i < set.size(); ++i) rank += binomial(set[i], i + 1);
  return rank;
}

/// The next set in the order of rank_of; false after the last with elements below n.
bool advance(SmallWorld::PointSet& set, std::size_t n) {
  for (std::size_t i = 0; i < set.size(); ++i) {
    const std::size_t limit = i + 1 < set.size() ? set[i + 1] : n;
    if (set[i] + std::size_t{1} < limit) {
      ++set[i];
      for (std::size_t j = 0; j < i; ++j) set[j] = static_cast<std::uint16_t>(j);
      return true;
    }
  }
  return false;
}

}  // namespace

SmallWorld::SmallWorld(const std::string& manifold, const std::array<long, 3>& divisions)
    : manifold_(manifold), dimension_(ref::find_entry(manifold)->dimension), divisions_(divisions) {
  const auto cosets = testing::cosets_of(ref::find_entry(manifold)->generators);
  Integer common(1);
  for (const long k : divisions_) common = lcm(common, Integer(k));
  for (const auto& g : cosets)
    for (int i = 0; i < dimension_; ++i) common = lcm(common, g.translation[i].denominator());
  unit_ = common.to_long();
  for (const auto& g : cosets) {
    IntMap map{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}};
    for (int i = 0; i < dimension_; ++i) {
      const auto row = static_cast<std::size_t>(i);
      map.translation[row] = (Rational(unit_) * g.translation[i]).numerator().to_long();
      for (int j = 0; j < dimension_; ++j)
        map.linear[row][static_cast<std::size_t>(j)] = g.linear(i, j).numerator().to_long();
    }
    cosets_.push_back(map);
    require(maps_grid_to_itself(map), "the group does not map the grid of " + manifold + " to itself");
  }
  number_orbits();
  find_symmetries();
}

std::size_t SmallWorld::code(const IntVector& x) const {
  std::size_t value = 0;
  for (std::size_t i = 0; i < 3; ++i)
    value = value * static_cast<std::size_t>(divisions_[i]) +
            static_cast<std::size_t>(floor_mod(x[i], unit_) * divisions_[i] / unit_);
  return value;
}

SmallWorld::IntVector SmallWorld::grid_point(std::size_t code) const {
  IntVector x{};
  for (std::size_t i = 3; i-- > 0;) {
    const auto k = static_cast<std::size_t>(divisions_[i]);
    x[i] = static_cast<long>(code % k) * (unit_ / divisions_[i]);
    code /= k;
  }
  return x;
}

SmallWorld::IntVector SmallWorld::apply(const IntMap& map, const IntVector& x) const {
  IntVector y = map.translation;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) y[i] += map.linear[i][j] * x[j];
  return y;
}

bool SmallWorld::maps_grid_to_itself(const IntMap& map) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const long step = unit_ / divisions_[i];
    if (map.translation[i] % step != 0) return false;
    for (std::size_t j = 0; j < 3; ++j)
      if (map.linear[i][j] * (unit_ / divisions_[j]) % step != 0) return false;
  }
  return true;
}

/// Is f g f^-1 in G for all g of G? With f = {N|s}: N R = R' N for a coset {R'|t'} with
/// N t + s - R' s - t' integral. (G = f G f^-1 follows, as both have the same covolume.)
bool SmallWorld::normalises_group(const IntMap& f) const {
  for (const IntMap& g : cosets_) {
    bool found = false;
    for (const IntMap& h : cosets_) {
      bool same = true;
      for (std::size_t i = 0; i < 3; ++i) {
        long difference = f.translation[i] - h.translation[i];
        for (std::size_t j = 0; j < 3; ++j) {
          difference += f.linear[i][j] * g.translation[j] - h.linear[i][j] * f.translation[j];
          long entry = 0;
          for (std::size_t k = 0; k < 3; ++k)
            entry += f.linear[i][k] * g.linear[k][j] - h.linear[i][k] * f.linear[k][j];
          same = same && entry == 0;
        }
        same = same && difference % unit_ == 0;
      }
      found = found || same;
    }
    if (!found) return false;
  }
  return true;
}

/// All N with entries -1, 0, 1 and N^T C N = C, C the canonical metric: in its reduced bases the minimal
/// vectors that make up the columns have such coordinates.
std::vector<SmallWorld::IntMatrix> SmallWorld::linear_isometries() const {
  const ref::Matrix& canonical = ref::find_entry(manifold_)->canonical_gram;
  IntMatrix metric{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
  for (int i = 0; i < dimension_; ++i)
    for (int j = 0; j < dimension_; ++j)
      metric[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          (Rational(2) * canonical(i, j)).numerator().to_long();
  const auto product = [&](const IntVector& a, const IntVector& b) {
    long sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum += a[i] * metric[i][j] * b[j];
    return sum;
  };
  std::vector<IntMatrix> result;
  std::vector<IntVector> columns;
  for (int c = 0; c < 27; ++c) columns.push_back({c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1});
  for (const IntVector& a : columns)
    for (const IntVector& b : columns)
      for (const IntVector& c : columns) {
        if (dimension_ == 2 && (a[2] != 0 || b[2] != 0 || c != IntVector{0, 0, 1})) continue;
        const std::array<IntVector, 3> n{a, b, c};
        bool isometry = true;
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j <= i; ++j) isometry = isometry && product(n[i], n[j]) == metric[i][j];
        if (!isometry) continue;
        IntMatrix m{};
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) m[i][j] = n[j][i];
        result.push_back(m);
      }
  return result;
}

void SmallWorld::number_orbits() {
  const auto size = static_cast<std::size_t>(divisions_[0] * divisions_[1] * divisions_[2]);
  orbit_of_.assign(size, 0);
  for (std::size_t c = 0; c < size; ++c) {
    std::size_t least = c;
    for (const IntMap& g : cosets_) least = std::min(least, code(apply(g, grid_point(c))));
    if (least == c) {
      orbit_of_[c] = static_cast<std::uint16_t>(representatives_.size());
      representatives_.push_back(c);
    } else {
      orbit_of_[c] = orbit_of_[least];
    }
  }
  require(representatives_.size() * cosets_.size() == size, "the group acts freely on the grid");
}

void SmallWorld::find_symmetries() {
  std::set<std::vector<std::uint16_t>> found;
  for (const IntMatrix& n : linear_isometries())
    for (std::size_t c = 0; c < orbit_of_.size(); ++c) {
      const IntMap f{n, grid_point(c)};
      if (!maps_grid_to_itself(f) || !normalises_group(f)) continue;
      std::vector<std::uint16_t> permutation;
      for (const std::size_t point : representatives_)
        permutation.push_back(orbit_of_[code(apply(f, grid_point(point)))]);
      found.insert(std::move(permutation));
    }
  permutations_.assign(found.begin(), found.end());
}

std::vector<SmallWorld::PointSet> SmallWorld::point_sets(std::size_t size) const {
  std::vector<PointSet> classes;
  if (size > orbits()) return classes;
  std::vector<bool> seen(binomial(orbits(), size), false);
  PointSet set(size);
  std::iota(set.begin(), set.end(), std::uint16_t{0});
  do {
    if (seen[rank_of(set)]) continue;
    classes.push_back(set);
    for (const auto& permutation : permutations_) {
      PointSet image;
      for (const std::uint16_t i : set) image.push_back(permutation[i]);
      std::sort(image.begin(), image.end());
      seen[rank_of(image)] = true;
    }
  } while (advance(set, orbits()));
  return classes;
}

std::size_t SmallWorld::count_by_burnside(std::size_t size) const {
  std::size_t fixed = 0;
  for (const auto& permutation : permutations_) {
    // The coefficient of x^size in the product of (1 + x^length) over the cycles.
    std::vector<std::size_t> polynomial(size + 1, 0);
    polynomial[0] = 1;
    std::vector<bool> visited(permutation.size(), false);
    for (std::size_t start = 0; start < permutation.size(); ++start) {
      std::size_t length = 0;
      for (std::size_t i = start; !visited[i]; i = permutation[i], ++length) visited[i] = true;
      if (length == 0) continue;
      for (std::size_t degree = size; degree >= length; --degree)
        polynomial[degree] += polynomial[degree - length];
    }
    fixed += polynomial[size];
  }
  require(fixed % permutations_.size() == 0, "the symmetries form a group");
  return fixed / permutations_.size();
}

ref::Instance SmallWorld::instance(const PointSet& points) const {
  testing::Specimen specimen = testing::empty_specimen(manifold_);
  for (const std::uint16_t orbit : points) {
    const IntVector x = grid_point(representatives_[orbit]);
    Vector point(dimension_);
    for (int i = 0; i < dimension_; ++i)
      point[i] = Rational(Integer(x[static_cast<std::size_t>(i)]), Integer(unit_));
    specimen.points.push_back(point);
  }
  return instance_of(specimen);
}

}  // namespace flatdt::property_tests
