/// Orientation and insphere of points of orbits: the filter and the exact integers agree with each other and
/// with the determinants in rationals; the perturbed predicate is the same with and without the filter.
#include <algorithm>

#include "../engine/expect.hpp"
#include "../engine/target.hpp"
#include "../specimen/known_group.hpp"
#include "../specimen/structured_target.hpp"
#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/predicates.hpp"

namespace flatdt::fuzz {

const Shape kShape = {.queries = true};

namespace {

using ref::Lift;
using ref::OrbitPoint;
using ref::Sign;

/// Expansion by the first row.
ref::Rational determinant(const std::vector<std::vector<ref::Rational>>& rows) {
  if (rows.size() == 1) return rows[0][0];
  ref::Rational sum;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    if (rows[0][j].is_zero()) continue;
    std::vector<std::vector<ref::Rational>> minor(rows.begin() + 1, rows.end());
    for (auto& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
    const ref::Rational term = rows[0][j] * determinant(minor);
    sum = j % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

std::vector<ref::Rational> entries(const ref::Vector& v) {
  std::vector<ref::Rational> row;
  for (int i = 0; i < v.dimension(); ++i) row.push_back(v[i]);
  return row;
}

template <int D>
class Comparison {
 public:
  using Simplex = std::array<Lift, D + 1>;

  Comparison(const ref::Frame& frame, const std::vector<ref::Vector>& points)
      : frame_(frame),
        table_(frame),
        sites_(ref::make_sites(frame, points)),
        order_(frame, table_),
        filtered_(frame, table_, sites_, order_, ref::PredicateStages::filtered),
        exact_(frame, table_, sites_, order_, ref::PredicateStages::exact_only) {}

  /// Every D+2 successive query points: a simplex and one more.
  void operator()(const std::vector<CodedQuery>& queries) {
    std::vector<Lift> lifts;
    for (const CodedQuery& query : queries) lifts.push_back(lift(query));
    for (std::size_t at = 0; at + D + 2 <= lifts.size(); ++at) {
      Simplex simplex;
      std::copy_n(lifts.begin() + static_cast<std::ptrdiff_t>(at), D + 1, simplex.begin());
      compare(simplex, lifts[at + D + 1]);
    }
  }

 private:
  Lift lift(const CodedQuery& query) const {
    ref::Element g;
    g.coset = static_cast<std::uint16_t>(query.coset % table_.cosets());
    for (std::size_t i = 0; i < D; ++i) g.t[i] = query.shift[i];
    const ref::SiteId site{static_cast<std::uint32_t>(query.point % sites_.size())};
    return {table_.apply(g, sites_[index_of(site)].approximate()), {site, g}};
  }

  ref::Vector position(const OrbitPoint& p) const {
    const ref::Site& site = sites_[index_of(p.site)];
    ref::Vector x(D);
    for (int i = 0; i < D; ++i) x[i] = ref::Rational(site.numerator(i), site.denominator());
    return table_.isometry(p.g) * x;
  }

  void compare(Simplex simplex, const Lift& w) {
    std::vector<std::vector<ref::Rational>> rows;
    for (std::size_t k = 1; k <= D; ++k)
      rows.push_back(entries(position(simplex[k].point) - position(simplex[0].point)));
    const Sign orientation = determinant(rows).sign();
    expect(exact_.orientation(simplex) == orientation,
           "the exact orientation is that of the rational determinant");
    expect(filtered_.orientation(simplex) == orientation, "the filtered orientation is exact");
    if (orientation == Sign::zero) return;
    if (orientation == Sign::negative) std::swap(simplex[0], simplex[1]);
    const auto is_w = [&](const Lift& v) { return v.point == w.point; };
    if (std::any_of(simplex.begin(), simplex.end(), is_w)) return;  // a requirement of the predicate
    rows.clear();
    for (const Lift& v : simplex) {
      const ref::Vector difference = position(v.point) - position(w.point);
      rows.push_back(entries(difference));
      rows.back().push_back(ref::squared_length(frame_.gram, difference));
    }
    const Sign insphere = D % 2 == 0 ? determinant(rows).sign() : -determinant(rows).sign();
    expect(exact_.insphere(simplex, w) == insphere, "the exact insphere is that of the rational determinant");
    expect(filtered_.insphere(simplex, w) == insphere, "the filtered insphere is exact");
    const bool conflict = exact_.conflict_sos(simplex, w);
    expect(filtered_.conflict_sos(simplex, w) == conflict, "the perturbed predicate is exact");
    expect(insphere == Sign::zero || conflict == (insphere == Sign::positive),
           "the perturbation decides ties only");
  }

  const ref::Frame& frame_;
  ref::GroupTable table_;
  std::vector<ref::Site> sites_;
  ref::TieOrder order_;
  ref::Predicates<D> filtered_;
  ref::Predicates<D> exact_;
};

}  // namespace
}  // namespace flatdt::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flatdt::fuzz;
  const Specimen specimen = decode({data, size}, kShape);
  const flatdt::ref::Instance instance = instance_of(specimen);
  try {
    const auto group = prepared(instance);
    if (instance.dimension == 2) {
      Comparison<2>(group->frame(), instance.points)(specimen.queries);
    } else {
      Comparison<3>(group->frame(), instance.points)(specimen.queries);
    }
  } catch (const flatdt::ref::InvalidInput&) {
  } catch (const flatdt::ref::LimitReached&) {
  }
  return 0;
}
