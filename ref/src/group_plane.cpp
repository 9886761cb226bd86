#include "group_plane.hpp"

#include <utility>

#include "flatdt/ref/errors.hpp"
#include "flatdt/ref/lattice.hpp"

namespace flatdt::ref {

PlaneLattice::PlaneLattice(const Matrix& gram, Vector p, Vector q)
    : ambient_(gram), p_(std::move(p)), q_(std::move(q)) {
  gram_(0, 0) = squared_length(ambient_, p_);
  gram_(1, 1) = squared_length(ambient_, q_);
  gram_(0, 1) = inner_product(ambient_, p_, q_);
  gram_(1, 0) = gram_(0, 1);
}

Vector PlaneLattice::coordinates(const Vector& v) const {
  Vector moments(2);
  moments[0] = inner_product(ambient_, p_, v);
  moments[1] = inner_product(ambient_, q_, v);
  return gram_.inverse() * moments;
}

Vector PlaneLattice::closest_to(const Vector& v) const {
  return at(closest_vectors(gram_, coordinates(v)).front());
}

Vector PlaneLattice::shortest_completion(const Vector& v) const {
  const Vector k = coordinates(v);
  ensure(k.is_integral(), "a vector to be completed lies in the lattice");
  const Integer k0 = k[0].numerator(), k1 = k[1].numerator();
  mpz_class g, s, t;
  mpz_gcdext(g.get_mpz_t(), s.get_mpz_t(), t.get_mpz_t(), k0.mpz().get_mpz_t(), k1.mpz().get_mpz_t());
  ensure(g == 1, "a vector to be completed is primitive");
  // det((t, -s), (k_0, k_1)) = t k_1 + s k_0 = 1; adding multiples of v keeps the determinant.
  const Vector w = Rational(Integer(t)) * p_ - Rational(Integer(s)) * q_;
  const Rational multiple = inner_product(ambient_, w, v) / squared_length(ambient_, v);
  return w - Rational(round_half_up(multiple)) * v;
}

}  // namespace flatdt::ref
