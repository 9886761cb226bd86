// Delaunay triangulations for tests, by gift wrapping the stars of all points in a finite cloud of lifts:
// slow, in 128-bit integers, and nothing in common with the checker but the group's tables. Ties throw.
#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "build.hpp"
#include "group.hpp"

namespace flatdt::checker::test {

__extension__ using Wide = __int128;

struct Tie : std::runtime_error {
  Tie() : std::runtime_error("cospherical points") {}
};

/// A lift: its coordinates times the denominator, and the point and element it comes from.
struct Lift {
  std::array<long, 3> x{};
  std::size_t point = 0;
  Element element;
};

class GiftWrap {
 public:
  using Cell = std::vector<std::size_t>;  // indices into the cloud

  /// `points` times 1/denominator, in [0,1)^d, in lattice coordinates; the metric of the instance times 2 is
  /// integral.
  GiftWrap(const Group& group, const Mat<Rational>& metric, const std::vector<std::array<long, 3>>& points,
           long denominator)
      : group_(group), d_(static_cast<std::size_t>(group.dimension)) {
    for (std::size_t i = 0; i < d_; ++i) {
      for (std::size_t j = 0; j < d_; ++j) gram_[i][j] = Rational(2 * metric[i][j]).get_num().get_si();
    }
    const long reach = 2;
    for (std::size_t p = 0; p < points.size(); ++p) {
      for (std::size_t r = 0; r < group.order(); ++r) {
        Lift base;
        base.point = p;
        base.element.rotation = static_cast<std::uint8_t>(r);
        Lift moved = base;
        for (std::size_t i = 0; i < d_; ++i) {
          const Rational t = group.translation[r][i] * denominator;
          if (t.get_den() != 1) throw std::logic_error("denominator too small");
          moved.x[i] = t.get_num().get_si();
          for (std::size_t k = 0; k < d_; ++k) moved.x[i] += group.linear[r][i][k].get_si() * points[p][k];
        }
        std::array<long, 3>
            home{};  // brings the image into [0,1)^d, so that the cloud surrounds it on all sides
        for (std::size_t i = 0; i < d_; ++i) {
          home[i] = -floor_div(static_cast<int>(moved.x[i]), static_cast<int>(denominator));
          moved.x[i] += home[i] * denominator;
        }
        for (long a = -reach; a <= reach; ++a) {
          for (long b = -reach; b <= reach; ++b) {
            for (long c = d_ == 3 ? -reach : 0; c <= (d_ == 3 ? reach : 0); ++c) {
              Lift lift = moved;
              const std::array<long, 3> l = {a, b, c};
              for (std::size_t i = 0; i < d_; ++i) {
                lift.x[i] += l[i] * denominator;
                lift.element.shift[i] = l[i] + home[i];
              }
              if (r == 0 && a == 0 && b == 0 && c == 0) centres_.push_back(cloud_.size());
              cloud_.push_back(lift);
            }
          }
        }
      }
    }
  }

  /// One cell of each G-orbit, as (point, element) pairs.
  std::vector<std::vector<std::pair<std::size_t, Element>>> cells() {
    std::set<std::vector<Key>> seen;
    std::vector<std::vector<std::pair<std::size_t, Element>>> result;
    for (const std::size_t centre : centres_) {
      for (const Cell& cell : star(centre)) {
        if (!seen.insert(canonical(cell)).second) continue;
        auto& out = result.emplace_back();
        for (const std::size_t i : cell) out.emplace_back(cloud_[i].point, cloud_[i].element);
      }
    }
    return result;
  }

 private:
  using Key = std::tuple<std::size_t, int, long, long, long>;

  std::vector<Key> canonical(const Cell& cell) const {
    std::vector<Key> best;
    for (const std::size_t base : cell) {
      const Element back = group_.invert(cloud_[base].element);
      std::vector<Key> keys;
      for (const std::size_t i : cell) {
        const Element e = group_.multiply(back, cloud_[i].element);
        keys.emplace_back(cloud_[i].point, e.rotation, e.shift[0].get_si(), e.shift[1].get_si(),
                          e.shift[2].get_si());
      }
      std::sort(keys.begin(), keys.end());
      if (best.empty() || keys < best) best = keys;
    }
    return best;
  }

  Wide quadratic(const std::array<long, 3>& v) const {
    Wide sum = 0;
    for (std::size_t i = 0; i < d_; ++i) {
      for (std::size_t j = 0; j < d_; ++j) sum += static_cast<Wide>(gram_[i][j]) * v[i] * v[j];
    }
    return sum;
  }

  std::array<long, 3> difference(std::size_t a, std::size_t b) const {
    std::array<long, 3> v{};
    for (std::size_t i = 0; i < d_; ++i) v[i] = cloud_[a].x[i] - cloud_[b].x[i];
    return v;
  }

  using Matrix = std::array<std::array<Wide, 4>, 4>;

  /// Expansion along row `row` over the columns in `columns`.
  static Wide expand(const Matrix& m, std::size_t n, std::size_t row, unsigned columns) {
    if (row == n) return 1;
    Wide sum = 0;
    bool minus = false;
    for (std::size_t k = 0; k < n; ++k) {
      if ((columns >> k & 1U) == 0) continue;
      const Wide term = m[row][k] * expand(m, n, row + 1, columns & ~(1U << k));
      sum += minus ? -term : term;
      minus = !minus;
    }
    return sum;
  }

  Wide orientation(const Cell& cell) const {
    Matrix rows{};
    for (std::size_t k = 1; k < cell.size(); ++k) {
      const auto v = difference(cell[k], cell[0]);
      std::copy(v.begin(), v.end(), rows[k - 1].begin());
    }
    return expand(rows, d_, 0, (1U << d_) - 1);
  }

  /// 1, 0 or -1: q inside, on or outside the circumsphere.
  int inside(const Cell& cell, std::size_t q) const {
    Matrix rows{};
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const auto v = difference(cell[k], q);
      std::copy(v.begin(), v.end(), rows[k].begin());
      rows[k][d_] = quadratic(v);
    }
    Wide det = expand(rows, d_ + 1, 0, (1U << (d_ + 1)) - 1);
    if (det == 0) return 0;
    if (d_ == 3) det = -det;
    return (det > 0) == (orientation(cell) > 0) ? 1 : -1;
  }

  /// The Delaunay apex of a facet on the side where orientation(facet, apex) has the given sign.
  Cell complete(Cell facet, bool positive) const {
    std::size_t best = cloud_.size();
    for (std::size_t q = 0; q < cloud_.size(); ++q) {
      if (std::find(facet.begin(), facet.end(), q) != facet.end()) continue;
      Cell cell = facet;
      cell.push_back(q);
      const Wide side = orientation(cell);
      if (side == 0 || (side > 0) != positive) continue;
      if (best != cloud_.size()) {
        cell.back() = best;
        if (inside(cell, q) <= 0) continue;
      }
      best = q;
    }
    if (best == cloud_.size()) throw Tie();  // three points on a line, or a facet at the rim of the cloud
    facet.push_back(best);
    for (std::size_t q = 0; q < cloud_.size(); ++q) {
      if (std::find(facet.begin(), facet.end(), q) == facet.end() && inside(facet, q) == 0) throw Tie();
    }
    return facet;
  }

  bool is_empty(const Cell& cell) const {
    for (std::size_t q = 0; q < cloud_.size(); ++q) {
      if (std::find(cell.begin(), cell.end(), q) == cell.end() && inside(cell, q) > 0) return false;
    }
    return true;
  }

  Cell first_cell(std::size_t centre) const {
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (i != centre) near.push_back(i);
    }
    std::sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) {
      return quadratic(difference(a, centre)) < quadratic(difference(b, centre));
    });
    if (d_ == 2) return complete({centre, near[0]}, true);  // the nearest neighbour is joined by an edge
    for (std::size_t k = 1; k < near.size(); ++k) {
      const Cell edge = {centre, near[0], near[k]};
      try {
        const Cell cell = complete(edge, true);
        if (is_empty(cell)) return cell;
      } catch (const Tie&) {  // of a triangle that need not be Delaunay
        continue;
      }
    }
    throw std::logic_error("no first cell");
  }

  std::set<Cell> star(std::size_t centre) const {
    std::set<Cell> done;
    std::vector<Cell> todo = {first_cell(centre)};
    std::set<Cell> seen;
    while (!todo.empty()) {
      const Cell cell = todo.back();
      todo.pop_back();
      Cell sorted = cell;
      std::sort(sorted.begin(), sorted.end());
      if (!seen.insert(sorted).second) continue;
      done.insert(cell);
      for (std::size_t opposite = 0; opposite < cell.size(); ++opposite) {
        if (cell[opposite] == centre) continue;
        Cell facet;
        for (std::size_t k = 0; k < cell.size(); ++k) {
          if (k != opposite) facet.push_back(cell[k]);
        }
        Cell here = facet;
        here.push_back(cell[opposite]);
        todo.push_back(complete(facet, orientation(here) < 0));
      }
    }
    return done;
  }

  const Group& group_;
  std::size_t d_;
  std::array<std::array<long, 3>, 3> gram_{};
  std::vector<Lift> cloud_;
  std::vector<std::size_t> centres_;
};

inline std::string seitz_text(int d, const Seitz& g) {
  std::string text;
  for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(d); ++j) text += g.linear[i][j].get_str() + " ";
    text += g.translation[i].get_str() + " ";
  }
  return text;
}

}  // namespace flatdt::checker::test
