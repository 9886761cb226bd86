#include "cover_search.hpp"

#include <algorithm>
#include <cstddef>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"

namespace flatdt::ref {
namespace {

/// Membership of v in the lattice of s; with `any_w`, whether some p and q make it a member (a necessary
/// condition: exact if v[0] is 0).
bool contains(const HermiteTriangle& s, const std::array<long, 3>& v, bool any_w) {
  if (v[0] % s.a != 0) return false;
  const long k = v[0] / s.a;
  if (k != 0 && any_w) return true;
  const long y = v[1] - k * s.p;
  if (y % s.b != 0) return false;
  return (v[2] - k * s.q - y / s.b * s.r) % s.c == 0;
}

std::array<long, 3> image(const std::array<std::array<long, 3>, 3>& linear, const std::array<long, 3>& v) {
  std::array<long, 3> result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = linear[i][0] * v[0] + linear[i][1] * v[1] + linear[i][2] * v[2];
  return result;
}

long small_integer(const Rational& value) {
  ensure(value.is_integer() && value.numerator().fits_long() &&
             abs(value) <= Rational(SublatticeSearch::kMaxCoordinate),
         "coordinates in a reduced frame are small integers");
  return value.numerator().to_long();
}

void add_to_layer(Layers& layers, long height, PlanePoint point) {
  if (static_cast<long>(layers.size()) <= height) layers.resize(static_cast<std::size_t>(height) + 1);
  layers[static_cast<std::size_t>(height)].push_back(point);
}

}  // namespace

SublatticeSearch::SublatticeSearch(const Frame& frame, const std::vector<Vector>& forbidden, long max_work)
    : dimension_(frame.dimension), max_work_(max_work) {
  choose_order(frame);
  for (const Isometry& coset : frame.cosets) {
    if (coset.linear.is_identity()) continue;
    Linear linear{};
    linear[0][0] = 1;
    for (int i = 0; i < dimension_; ++i)
      for (int j = 0; j < dimension_; ++j) linear[slot(i)][slot(j)] = small_integer(coset.linear(i, j));
    holonomy_.push_back(linear);
  }
  for (const Vector& v : forbidden) {
    Column x{};
    for (int i = 0; i < dimension_; ++i) x[slot(i)] = small_integer(v[i]);
    // Of v and -v only the one whose first nonzero coordinate is positive.
    if (x[0] > 0) add_to_layer(space_layers_, x[0], {x[1], x[2]});
    if (x[0] == 0 && x[1] > 0) add_to_layer(plane_layers_, x[1], {0, x[2]});
    if (x[0] == 0 && x[1] == 0 && x[2] > 0) axis_.push_back(x[2]);
  }
  for (Layers* layers : {&space_layers_, &plane_layers_})
    for (auto& layer : *layers) std::sort(layer.begin(), layer.end());
}

void SublatticeSearch::choose_order(const Frame& frame) {
  if (dimension_ == 2 || frame.cosets.size() == 1) return;
  const bool plane_is_fixed =
      std::all_of(frame.cosets.begin(), frame.cosets.end(), [](const Isometry& coset) {
        const Matrix& m = coset.linear;
        return m(0, 1).is_zero() && m(1, 0).is_zero() && m(2, 0).is_zero() && m(2, 1).is_zero() &&
               m(0, 0) == m(1, 1);
      });
  if (plane_is_fixed) slot_ = {2, 0, 1};
}

bool SublatticeSearch::is_invariant(const HermiteTriangle& s) const {
  const std::array<Column, 3> columns = {Column{s.a, s.p, s.q}, Column{0, s.b, s.r}, Column{0, 0, s.c}};
  return std::all_of(holonomy_.begin(), holonomy_.end(), [&](const Linear& linear) {
    return std::all_of(columns.begin(), columns.end(),
                       [&](const Column& column) { return contains(s, image(linear, column), false); });
  });
}

bool SublatticeSearch::may_be_invariant(const HermiteTriangle& plane) const {
  return std::all_of(holonomy_.begin(), holonomy_.end(), [&](const Linear& linear) {
    return contains(plane, image(linear, {0, plane.b, plane.r}), true) &&
           contains(plane, image(linear, {0, 0, plane.c}), true);
  });
}

void SublatticeSearch::record(const HermiteTriangle& s) {
  HermiteBasis normal_form(dimension_);
  for (const Column& column : {Column{s.a, s.p, s.q}, Column{0, s.b, s.r}, Column{0, 0, s.c}}) {
    Vector v(dimension_);  // for d = 2 the first column has nothing in the plane
    for (int i = 0; i < dimension_; ++i) v[i] = column[slot(i)];
    normal_form.add(v);
  }
  Matrix basis(dimension_);
  for (int j = 0; j < dimension_; ++j)
    basis.set_column(j, normal_form.vectors()[static_cast<std::size_t>(j)]);
  if (!best_ || basis.transpose() < *best_) best_ = basis.transpose();
}

/// All w for the plane lattice <(0,b,r),(0,0,c)>.
void SublatticeSearch::search_plane(HermiteTriangle s) {
  bool prepared = false;
  const long p_end = dimension_ == 2 ? 1 : s.b, q_end = dimension_ == 2 ? 1 : s.c;
  work_ += p_end * q_end;
  for (s.p = 0; s.p < p_end; ++s.p) {
    for (s.q = 0; s.q < q_end; ++s.q) {
      if (!is_invariant(s)) continue;
      if (!prepared) plane_sieve_.prepare(s.b, s.r, s.c, s.a, space_layers_);
      prepared = true;
      if (plane_sieve_.is_free({s.p, s.q})) record(s);
    }
  }
}

/// All plane lattices for s.a, s.b and s.c.
void SublatticeSearch::search_planes(HermiteTriangle s) {
  if (std::any_of(axis_.begin(), axis_.end(), [&](long z) { return z % s.c == 0; })) return;
  // The sublattice in height 0 must avoid the forbidden vectors there: prunes most planes.
  line_sieve_.prepare(1, 0, s.c, s.b, plane_layers_);
  for (s.r = 0; s.r < s.c && !exhausted(); ++s.r)
    if (line_sieve_.is_free({0, s.r}) && may_be_invariant(s)) search_plane(s);
}

std::optional<Sublattice> SublatticeSearch::least_of_index(long index) {
  best_.reset();
  HermiteTriangle s;
  for (s.a = 1; s.a <= (dimension_ == 2 ? 1 : index); ++s.a) {
    if (index % s.a != 0) continue;
    const long plane_index = index / s.a;
    for (s.b = 1; s.b <= plane_index; ++s.b) {
      if (plane_index % s.b != 0) continue;
      s.c = plane_index / s.b;
      search_planes(s);
    }
  }
  if (!best_ || exhausted()) return std::nullopt;
  return Sublattice{best_->transpose(), index, index * (1 + static_cast<long>(holonomy_.size()))};
}

}  // namespace flatdt::ref
