#include "orbits.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <utility>

#include "linear.hpp"

namespace flatdt::checker {
namespace {

struct Canonical {
  LatticePoint point;
  Element to_point;  // point of the instance = to_point * canonical point
};

int compare(const Vec<Integer>& a, const Vec<Integer>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (const int c = cmp(a[i], b[i]); c != 0) return c;
  }
  return 0;
}

// All images of one point are compared over one denominator; only the minimum is brought to lowest terms.
Canonical canonical_point(const Group& group, const Integer& group_denominator, const Vec<Rational>& point) {
  const int d = group.dimension;
  const Vec<Rational> x = multiply(d, group.basis_inverse, point);
  LatticePoint best;
  best.denominator = group_denominator;
  for (const Rational& coordinate : x) best.denominator = lcm(best.denominator, coordinate.get_den());
  Vec<Integer> scaled;
  for (std::size_t i = 0; i < 3; ++i) scaled[i] = x[i].get_num() * (best.denominator / x[i].get_den());
  Element to_canonical;
  for (std::size_t r = 0; r < group.order(); ++r) {
    Vec<Integer> image = multiply(d, group.linear[r], scaled);
    Vec<Integer> shift;
    for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
      const Rational& t = group.translation[r][i];
      image[i] += t.get_num() * (best.denominator / t.get_den());
      mpz_fdiv_qr(shift[i].get_mpz_t(), image[i].get_mpz_t(), image[i].get_mpz_t(),
                  best.denominator.get_mpz_t());
      shift[i] = -shift[i];
    }
    if (r == 0 || compare(image, best.numerator) < 0) {
      best.numerator = std::move(image);
      to_canonical = {static_cast<std::uint8_t>(r), std::move(shift)};
    }
  }
  Integer common = best.denominator;
  for (const Integer& n : best.numerator) common = gcd(common, n);
  for (Integer& n : best.numerator) n /= common;
  best.denominator /= common;
  return {std::move(best), group.invert(to_canonical)};
}

/// The same on machine integers over the denominator of the points.
class FixedImages {
 public:
  /// Requires: |coordinates| <= most.
  static std::optional<FixedImages> make(const Group& group, std::int64_t denominator, std::int64_t most) {
    FixedImages images(denominator);
    for (std::size_t r = 0; r < group.order(); ++r) {
      const std::optional<FixedMap> map =
          fixed_map(group, {static_cast<std::uint8_t>(r), {}}, denominator, most);
      if (!map) return std::nullopt;
      images.maps_.push_back(*map);
    }
    return images;
  }

  struct Least {
    Vec<std::int64_t> point;
    std::uint8_t rotation;
    Vec<std::int64_t> shift;  // the canonical point is {I|shift} s_rotation * point
  };
  [[nodiscard]] Least least(const Vec<std::int64_t>& point) const {
    Least best{};
    for (std::size_t r = 0; r < maps_.size(); ++r) {
      Vec<std::int64_t> image = maps_[r](point);
      Vec<std::int64_t> shift{};
      for (std::size_t i = 0; i < 3; ++i) {
        std::int64_t floor = image[i] / denominator_;
        if (image[i] % denominator_ < 0) --floor;
        image[i] -= floor * denominator_;
        shift[i] = -floor;
      }
      if (r == 0 || image < best.point) best = {image, static_cast<std::uint8_t>(r), shift};
    }
    return best;
  }

 private:
  explicit FixedImages(std::int64_t denominator) : denominator_(denominator) {}
  std::int64_t denominator_;
  std::vector<FixedMap> maps_;
};

/// Sorts 0..n-1 by value and then by index; `before` and `equal` compare values. Returns for each the least
/// index of the same value.
template <class Before, class Equal>
std::vector<std::uint32_t> leaders(std::size_t n, Before before, Equal equal) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return before(a, b) || (equal(a, b) && a < b); });
  std::vector<std::uint32_t> leader(n);
  for (std::size_t k = 0; k < n; ++k) {
    leader[order[k]] = k > 0 && equal(order[k - 1], order[k]) ? leader[order[k - 1]] : order[k];
  }
  return leader;
}

/// Fills all but the coordinates; calls keep(i) for the first point of each orbit.
template <class Keep>
void number_orbits(const std::vector<std::uint32_t>& leader, Orbits& orbits, Keep keep) {
  for (std::size_t i = 0; i < leader.size(); ++i) {
    if (leader[i] == i) {
      orbits.of_point.push_back(make_id<OrbitId>(orbits.first_point.size()));
      orbits.first_point.push_back(make_id<PointId>(i));
      keep(i);
    } else {
      orbits.of_point.push_back(orbits.of_point[leader[i]]);  // the leader comes first
    }
  }
}

/// Makes the orbits in machine integers; false, with nothing done, if some number does not fit.
bool make_fixed_orbits(const Instance& instance, ElementTable& table, Orbits& orbits) {
  const Group& group = table.group();
  std::optional<FixedPoints> points = fixed_points(instance, group);
  if (!points) return false;
  std::int64_t most = 0;
  for (const Vec<std::int64_t>& x : points->numerator) {
    for (const std::int64_t coordinate : x) most = std::max(most, std::abs(coordinate));
  }
  const std::optional<FixedImages> images = FixedImages::make(group, points->denominator, most);
  if (!images) return false;
  std::map<std::pair<std::uint8_t, Vec<std::int64_t>>, ElementId> frames;  // few are different
  for (Vec<std::int64_t>& x : points->numerator) {
    const FixedImages::Least least = images->least(x);
    const auto [frame, inserted] = frames.try_emplace({least.rotation, least.shift}, kIdentity);
    if (inserted) {
      const Element to_canonical{least.rotation, {least.shift[0], least.shift[1], least.shift[2]}};
      frame->second = table.intern(group.invert(to_canonical));
    }
    orbits.frame.push_back(frame->second);
    x = least.point;
  }
  std::vector<Vec<std::int64_t>>& x = points->numerator;
  const auto leader = leaders(
      x.size(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; },
      [&](std::size_t a, std::size_t b) { return x[a] == x[b]; });
  std::size_t kept = 0;
  number_orbits(leader, orbits, [&](std::size_t i) { x[kept++] = x[i]; });
  x.resize(kept);
  orbits.fixed = std::move(points);
  return true;
}

}  // namespace

Orbits make_orbits(const Instance& instance, ElementTable& table, bool fixed_width) {
  Orbits orbits;
  if (fixed_width && make_fixed_orbits(instance, table, orbits)) return orbits;
  const Group& group = table.group();
  Integer group_denominator = 1;
  for (const Vec<Rational>& t : group.translation) {
    for (const Rational& x : t) group_denominator = lcm(group_denominator, x.get_den());
  }
  std::vector<LatticePoint> points;
  for (const Vec<Rational>& point : instance.points) {
    Canonical canonical = canonical_point(group, group_denominator, point);
    points.push_back(std::move(canonical.point));
    orbits.frame.push_back(table.intern(canonical.to_point));
  }
  const auto order = [&](std::size_t a, std::size_t b) {
    const int c = cmp(points[a].denominator, points[b].denominator);
    return c != 0 ? c : compare(points[a].numerator, points[b].numerator);
  };
  const auto leader = leaders(
      points.size(), [&](std::size_t a, std::size_t b) { return order(a, b) < 0; },
      [&](std::size_t a, std::size_t b) { return order(a, b) == 0; });
  number_orbits(leader, orbits, [&](std::size_t i) { orbits.canonical.push_back(std::move(points[i])); });
  return orbits;
}

}  // namespace flatdt::checker
