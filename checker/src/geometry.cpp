#include "geometry.hpp"

#include <utility>

#include "linear.hpp"

namespace flatdt::checker {
namespace {

Mat<Rational> lattice_gram(const Group& group, const Mat<Rational>& metric) {
  const int d = group.dimension;
  return multiply(d, transpose(group.basis), multiply(d, metric, group.basis));
}

/// out = a b - c e.
void cross(Integer& out, const Integer& a, const Integer& b, const Integer& c, const Integer& e) {
  mpz_mul(out.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  mpz_submul(out.get_mpz_t(), c.get_mpz_t(), e.get_mpz_t());
}

}  // namespace

Geometry::Geometry(const Complex& complex, const Orbits& orbits, const ElementTable& table,
                   const Mat<Rational>& metric, const Stages& stages)
    : complex_(complex),
      table_(table),
      stages_(stages),
      dimension_(table.group().dimension),
      group_denominator_(1) {
  const Group& group = table.group();
  const Mat<Rational> gram = lattice_gram(group, metric);
  Integer scale = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Rational& x : gram[i]) scale = lcm(scale, x.get_den());
    for (const Vec<Rational>& t : group.translation)
      group_denominator_ = lcm(group_denominator_, t[i].get_den());
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) gram_[i][j] = gram[i][j].get_num() * (scale / gram[i][j].get_den());
  }
  for (std::size_t r = 0; r < group.order(); ++r) {
    Vec<Integer>& t = translations_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational& x = group.translation[r][i];
      t[i] = x.get_num() * (group_denominator_ / x.get_den());
    }
  }
  if (stages.fixed_width) fixed_ = FixedGeometry::make(complex, orbits, table, gram_);
  if (fixed_) {
    for (Integer& denominator : denominators_) denominator = fixed_->denominator();
  } else {
    make_bases(orbits);
    make_balls(gram);
  }
}

void Geometry::make_bases(const Orbits& orbits) {
  base_.reserve(complex_.vertices.size());
  for (const auto& [orbit, coset] : complex_.vertices) {
    LatticePoint canonical;
    if (orbits.fixed) {
      const Vec<std::int64_t>& x = orbits.fixed->numerator[index(orbit)];
      canonical = {{x[0], x[1], x[2]}, orbits.fixed->denominator};
    } else {
      canonical = orbits.canonical[index(orbit)];
    }
    LatticePoint& base = base_.emplace_back();
    base.denominator = lcm(canonical.denominator, group_denominator_);
    Vec<Rational> x;
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = Rational(canonical.numerator[i], canonical.denominator);
      x[i].canonicalize();
    }
    x = apply(dimension_, table_.group().lattice_seitz(table_[coset]), x);
    for (std::size_t i = 0; i < 3; ++i) {
      base.numerator[i] = x[i].get_num() * (base.denominator / x[i].get_den());
    }
  }
}

Vec<Rational> Geometry::point(VertexId v, ElementId offset) const {
  Vec<Rational> x;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = fixed_ ? Rational(fixed_->base(v)[i], fixed_->denominator())
                  : Rational(base_[index(v)].numerator[i], base_[index(v)].denominator);
    x[i].canonicalize();
  }
  return apply(dimension_, table_.group().lattice_seitz(table_[offset]), x);
}

// Over the denominator D of the base lift: D (R x + t + l) = R X + (D/N) T + D l, with t = T/N.
void Geometry::lift(const Lift& l, std::size_t slot) {
  Point& out = points_[slot];
  Integer& denominator = denominators_[slot];
  for (std::size_t i = 0; i < 3; ++i) {
    if (fixed_) {
      x_[i] = fixed_->base(l.vertex)[i];
    } else {
      x_[i] = base_[index(l.vertex)].numerator[i];
    }
  }
  if (!fixed_) denominator = base_[index(l.vertex)].denominator;
  const Element& g = table_[l.offset];
  const auto n = static_cast<std::size_t>(dimension_);
  if (g.rotation == 0) {
    for (std::size_t i = 0; i < n; ++i) out[i] = x_[i];
  } else {
    const Mat<Integer>& linear = table_.group().linear[g.rotation];
    mpz_divexact(factor_.get_mpz_t(), denominator.get_mpz_t(), group_denominator_.get_mpz_t());
    for (std::size_t i = 0; i < n; ++i) {
      mpz_mul(out[i].get_mpz_t(), factor_.get_mpz_t(), translations_[g.rotation][i].get_mpz_t());
      for (std::size_t k = 0; k < n; ++k) {
        mpz_addmul(out[i].get_mpz_t(), linear[i][k].get_mpz_t(), x_[k].get_mpz_t());
      }
    }
  }
  if (l.offset == kIdentity) return;
  for (std::size_t i = 0; i < n; ++i) {
    mpz_addmul(out[i].get_mpz_t(), denominator.get_mpz_t(), g.shift[i].get_mpz_t());
  }
}

/// Scales the first `count` points to the least common multiple of their denominators, left in common_.
void Geometry::bring_to_common_denominator(std::size_t count) {
  common_ = denominators_[0];
  bool equal = true;
  for (std::size_t k = 1; k < count; ++k) {
    if (denominators_[k] == common_) continue;
    equal = false;
    mpz_lcm(common_.get_mpz_t(), common_.get_mpz_t(), denominators_[k].get_mpz_t());
  }
  if (equal) return;
  for (std::size_t k = 0; k < count; ++k) {
    if (denominators_[k] == common_) continue;
    mpz_divexact(factor_.get_mpz_t(), common_.get_mpz_t(), denominators_[k].get_mpz_t());
    for (Integer& x : points_[k]) x *= factor_;
  }
}

/// Leaves the determinant of the normalised cell in determinant_ / power_.
void Geometry::determinant(const Cell& cell) {
  const auto n = static_cast<std::size_t>(dimension_);
  for (std::size_t k = 0; k <= n; ++k) lift({cell.vertex[k], complex_.offsets(cell)[0][k]}, k);
  bring_to_common_denominator(n + 1);
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = 0; i < n; ++i) points_[k][i] -= points_[0][i];
  }
  const Point& p = points_[1];
  const Point& q = points_[2];
  cross(determinant_, p[0], q[1], p[1], q[0]);
  if (n == 3) {
    const Point& r = points_[3];
    mpz_mul(determinant_.get_mpz_t(), determinant_.get_mpz_t(), r[2].get_mpz_t());
    cross(a_, p[1], q[2], p[2], q[1]);
    mpz_addmul(determinant_.get_mpz_t(), a_.get_mpz_t(), r[0].get_mpz_t());
    cross(a_, p[2], q[0], p[0], q[2]);
    mpz_addmul(determinant_.get_mpz_t(), a_.get_mpz_t(), r[1].get_mpz_t());
  }
  mpz_pow_ui(power_.get_mpz_t(), common_.get_mpz_t(), n);
}

VolumeSum Geometry::no_volume() const {
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), fixed_ ? static_cast<unsigned long>(fixed_->denominator()) : 1,
                static_cast<unsigned long>(dimension_));
  return VolumeSum(power);
}

Sign Geometry::orientation(const Cell& cell, VolumeSum& sum) {
  if (fixed_) {
    std::array<Lift, 4> corners{};
    for (std::size_t k = 0; k < complex_.corners; ++k) {
      corners[k] = {cell.vertex[k], complex_.offsets(cell)[0][k]};
    }
    if (const std::optional<Wide<3>> det = fixed_->determinant(corners)) {
      sum.add(*det);
      return sign_of(*det);
    }
  }
  const std::lock_guard lock(mutex_);
  determinant(cell);
  sum.add(determinant_, power_);
  return sign_of(determinant_);
}

void Geometry::squared_norm(const Point& v, Integer& out) {
  const auto n = static_cast<std::size_t>(dimension_);
  out = 0;
  for (std::size_t i = 0; i < n; ++i) {
    a_ = 0;
    for (std::size_t j = 0; j < n; ++j) mpz_addmul(a_.get_mpz_t(), gram_[i][j].get_mpz_t(), v[j].get_mpz_t());
    mpz_addmul(out.get_mpz_t(), a_.get_mpz_t(), v[i].get_mpz_t());
  }
}

// Laplace expansion by the first two columns against the last two (3D), or along the last column (2D).
Sign Geometry::insphere_exact(const std::array<Lift, 5>& points, Sign orientation) {
  const auto n = static_cast<std::size_t>(dimension_);
  for (std::size_t k = 0; k <= n + 1; ++k) lift(points[k], k);
  bring_to_common_denominator(n + 2);
  for (std::size_t k = 0; k <= n; ++k) {
    for (std::size_t i = 0; i < n; ++i) points_[k][i] -= points_[n + 1][i];
    squared_norm(points_[k], norms_[k]);
  }
  determinant_ = 0;
  if (n == 2) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = points_[(k + 1) % 3];
      const Point& q = points_[(k + 2) % 3];
      cross(a_, p[0], q[1], p[1], q[0]);
      mpz_addmul(determinant_.get_mpz_t(), a_.get_mpz_t(), norms_[k].get_mpz_t());
    }
    const Sign sign = sign_of(determinant_);
    return orientation == Sign::positive ? sign : opposite(sign);
  }
  // Rows (i, j) in the first two columns against the complementary rows (k, l), with the sign of (i, j, k,
  // l).
  constexpr std::array<std::array<std::size_t, 4>, 6> kSplits = {
      {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};
  for (const auto& [i, j, k, l] : kSplits) {  // every split is an even permutation
    cross(a_, points_[i][0], points_[j][1], points_[i][1], points_[j][0]);
    cross(b_, points_[k][2], norms_[l], norms_[k], points_[l][2]);
    mpz_addmul(determinant_.get_mpz_t(), a_.get_mpz_t(), b_.get_mpz_t());
  }
  const Sign sign = sign_of(determinant_);
  return orientation == Sign::positive ? opposite(sign) : sign;  // (-1)^3
}

std::array<Lift, 5> Geometry::lifts(const Cell& cell, std::size_t frame, const Lift& q) const {
  const std::array<ElementId, 4>& offset = complex_.offsets(cell)[frame];
  std::array<Lift, 5> points{};
  for (std::size_t k = 0; k < complex_.corners; ++k) points[k] = {cell.vertex[k], offset[k]};
  points[complex_.corners] = q;
  return points;
}

Sign Geometry::insphere(const Cell& cell, std::size_t frame, Sign orientation, const Lift& q) {
  const std::array<Lift, 5> points = lifts(cell, frame, q);
  std::optional<Sign> sign;
  if (fixed_) {
    sign = fixed_->insphere(points, orientation, stages_.filter ? FixedStage::both : FixedStage::limbs);
    if (sign) return *sign;
  }
  const std::lock_guard lock(mutex_);
  if (!fixed_ && stages_.filter) sign = insphere_balls(points, orientation);
  return sign ? *sign : insphere_exact(points, orientation);
}

}  // namespace flatdt::checker
