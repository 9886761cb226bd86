#include "simplify.hpp"

#include <algorithm>

#include "metrics.hpp"

namespace flatdt::testing {
namespace {

using ref::Integer;
using ref::Isometry;
using ref::Matrix;
using ref::Rational;
using ref::Vector;

std::size_t bits(const Integer& n) {
  return n.is_zero() ? 0 : n.bits();
}
std::size_t bits(const Rational& x) {
  return bits(x.numerator()) + bits(x.denominator()) - 1;
}
std::size_t bits(const Matrix& m) {
  std::size_t sum = 0;
  for (int i = 0; i < m.dimension(); ++i)
    for (int j = 0; j < m.dimension(); ++j) sum += bits(m(i, j));
  return sum;
}
std::size_t bits(const Vector& v) {
  std::size_t sum = 0;
  for (int i = 0; i < v.dimension(); ++i) sum += bits(v[i]);
  return sum;
}

bool precedes(const Rational& a, const Rational& b) {
  if (a.denominator() != b.denominator()) return a.denominator() < b.denominator();
  return abs(a.numerator()) < abs(b.numerator());
}

std::size_t place(const Specimen& s, const Domain& domain) {
  const auto at = std::find(domain.manifolds.begin(), domain.manifolds.end(), name_of(s));
  return static_cast<std::size_t>(at - domain.manifolds.begin());
}

/// The same points on another manifold, with its catalogue metric and coordinates.
Specimen on_manifold(const Specimen& s, const std::string& name) {
  Specimen other = empty_specimen(name);
  other.family = s.family;
  other.naming = s.naming;
  other.choice = s.choice;
  for (const Vector& x : s.points) {
    Vector y(other.dimension());
    for (int i = 0; i < y.dimension(); ++i) y[i] = i < x.dimension() ? x[i] : Rational(0);
    other.points.push_back(y);
  }
  return other;
}

void add_metrics(const Specimen& s, std::vector<Specimen>& result) {
  Specimen t = s;
  t.gram = s.entry->canonical_gram;
  result.push_back(t);
  const std::vector<Isometry> cosets = cosets_of(catalogue_generators(s));
  for (const long denominator : {1L, 2L, 4L, 8L}) {
    Matrix rounded(s.dimension());
    for (int i = 0; i < s.dimension(); ++i)
      for (int j = 0; j < s.dimension(); ++j)
        rounded(i, j) = Rational(round_half_up(Rational(denominator) * s.gram(i, j)), Integer(denominator));
    t.gram = rounded;
    if (is_admissible(t.gram, cosets)) result.push_back(t);
  }
}

void add_fewer_points(const Specimen& s, std::vector<Specimen>& result) {
  for (std::size_t chunk = s.points.size() / 2; chunk > 0; chunk /= 2)
    for (std::size_t i = 0; i + chunk <= s.points.size() && chunk < s.points.size(); i += chunk) {
      Specimen t = s;
      const auto first = t.points.begin() + static_cast<std::ptrdiff_t>(i);
      t.points.erase(first, first + static_cast<std::ptrdiff_t>(chunk));
      result.push_back(std::move(t));
    }
}

void add_simpler_points(const Specimen& s, std::vector<Specimen>& result) {
  for (std::size_t i = 0; i < s.points.size(); ++i)
    for (int k = 0; k < s.dimension(); ++k)
      for (const Rational& value : simpler(s.points[i][k])) {
        Specimen t = s;
        t.points[i][k] = value;
        result.push_back(std::move(t));
      }
}

}  // namespace

std::vector<Rational> simpler(const Rational& x) {
  const Rational inside = x - Rational(floor(x));
  std::vector<Rational> candidates{Rational(0), inside};
  for (const Rational& y : {inside, x}) {
    for (const long q : {1L, 2L, 3L, 4L, 5L, 6L, 8L, 12L, 16L, 64L, 1024L})
      candidates.emplace_back(round_half_up(Rational(q) * y), Integer(q));
    const Integer half = floor_div(y.denominator(), Integer(2));
    if (!half.is_zero()) candidates.emplace_back(round_half_up(Rational(half) * y), half);
  }
  candidates.emplace_back(floor_div(x.numerator(), Integer(2)), x.denominator());
  candidates.push_back(x - Rational(1));
  candidates.push_back(x + Rational(1));
  std::vector<Rational> result;
  for (const Rational& c : candidates)
    if (precedes(c, x) && std::find(result.begin(), result.end(), c) == result.end()) result.push_back(c);
  return result;
}

Weight weight(const Specimen& s, const Domain& domain) {
  Weight w;
  w.manifold = place(s, domain);
  w.points = s.points.size();
  const bool other_generators = s.generators != catalogue_generators(s);
  const bool other_gram = s.gram != s.entry->canonical_gram;
  w.description =
      static_cast<std::size_t>(s.naming) + (other_gram ? 2 + bits(s.gram) : 0) +
      (other_generators ? 100 : 0) +
      (s.coordinates.is_identity() ? 0 : 2 + bits(s.coordinates.linear) + bits(s.coordinates.translation));
  for (const Vector& x : s.points)
    for (int k = 0; k < x.dimension(); ++k) {
      w.denominators += bits(x[k].denominator()) - 1;
      w.numerators += bits(x[k].numerator());
    }
  w.choice = s.choice;
  return w;
}

std::vector<Specimen> simpler(const Specimen& s, const Domain& domain) {
  std::vector<Specimen> candidates;
  for (std::size_t i = 0; i < place(s, domain) && i < domain.manifolds.size(); ++i)
    candidates.push_back(on_manifold(s, domain.manifolds[i]));
  Specimen t = s;
  t.coordinates = Isometry::identity(s.dimension());
  t.generators = catalogue_generators(s);
  t.gram = s.entry->canonical_gram;
  t.naming = Naming::name_only;
  t.alias.clear();
  candidates.push_back(t);
  add_fewer_points(s, candidates);
  t.gram = s.gram;
  candidates.push_back(t);
  t = s;
  t.generators = catalogue_generators(s);
  candidates.push_back(t);
  t = s;
  t.coordinates.translation = Vector(s.dimension());
  candidates.push_back(t);
  t = s;
  t.coordinates.linear = Matrix::identity(s.dimension());
  candidates.push_back(t);
  t = s;
  t.naming = Naming::name_only;
  candidates.push_back(t);
  t = s;
  t.alias.clear();
  candidates.push_back(t);
  add_metrics(s, candidates);
  add_simpler_points(s, candidates);
  for (const std::uint64_t choice : {std::uint64_t{0}, s.choice / 2}) {
    t = s;
    t.choice = choice;
    candidates.push_back(t);
  }
  const Weight now = weight(s, domain);
  std::vector<Specimen> result;
  for (Specimen& c : candidates) {
    if (static_cast<long>(c.points.size()) > domain.max_points(c.dimension())) continue;
    if (weight(c, domain) < now) result.push_back(std::move(c));
  }
  return result;
}

}  // namespace flatdt::testing
