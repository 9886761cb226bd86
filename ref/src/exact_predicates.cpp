#include "flatdt/ref/exact_predicates.hpp"

namespace flatdt::ref {
namespace {

void submul(mpz_class& x, const mpz_class& a, const mpz_class& b) {
  mpz_submul(x.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}
void addmul(mpz_class& x, const mpz_class& a, const mpz_class& b) {
  mpz_addmul(x.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}
void mul(mpz_class& x, const mpz_class& a, const mpz_class& b) {
  mpz_mul(x.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}
void add_small_multiple(mpz_class& x, const mpz_class& a, int factor) {
  if (factor > 0)
    mpz_addmul_ui(x.get_mpz_t(), a.get_mpz_t(), static_cast<unsigned long>(factor));
  else if (factor < 0)
    mpz_submul_ui(x.get_mpz_t(), a.get_mpz_t(), static_cast<unsigned long>(-factor));
}
Sign sign_of(const mpz_class& x) {
  return sign_of_int(sgn(x));
}

}  // namespace

template <int D>
IntegralMetric<D>::IntegralMetric(const Frame& frame) {
  Integer common = 1;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) common = lcm(common, frame.gram(i, j).denominator());
  denominator = common.mpz();
  const Matrix scaled = Rational(common) * frame.gram;
  const Rational det = scaled.determinant();
  const Matrix adjoint_matrix = det * scaled.inverse();
  determinant = det.numerator().mpz();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      const auto r = static_cast<std::size_t>(i), c = static_cast<std::size_t>(j);
      gram[r][c] = scaled(i, j).numerator().mpz();
      adjoint[r][c] = adjoint_matrix(i, j).numerator().mpz();
    }
}

template <int D>
void ExactPredicates<D>::load(const OrbitPoint& p, Row& coordinates, mpz_class& denominator) {
  const Site& site = (*sites_)[index_of(p.site)];
  const LargeSite* const large = site.form->large.get();
  if (large == nullptr) {
    mpz_set_si(denominator.get_mpz_t(), site.form->small_denominator);
    for (std::size_t j = 0; j < D; ++j) mpz_set_si(small_[j].get_mpz_t(), site.small[j]);
  } else {
    denominator = large->denominator;
  }
  const mpz_class* const numerators = large != nullptr ? large->numerators.data() : small_.data();
  const GroupTable::Linear& linear = table_->linear(p.g.coset);
  const std::array<int, 3>& tau = table_->scaled_tau(p.g.coset);
  // The site's denominator is a multiple of the translation denominator: unit = denominator / translation
  // denominator.
  mpz_divexact_ui(t0_.get_mpz_t(), denominator.get_mpz_t(),
                  static_cast<unsigned long>(table_->translation_denominator()));
  for (std::size_t i = 0; i < D; ++i) {
    mpz_class& x = coordinates[i];
    x = 0;
    for (std::size_t j = 0; j < D; ++j) add_small_multiple(x, numerators[j], linear[3 * i + j]);
    add_small_multiple(x, t0_, tau[i] + table_->translation_denominator() * p.g.t[i]);
  }
}

template <int D>
void ExactPredicates<D>::load_differences(const OrbitPoint* p, std::size_t count, const OrbitPoint& w) {
  load(w, points_[count], denominators_[count]);
  bool same = true;
  for (std::size_t k = 0; k < count; ++k) {
    load(p[k], points_[k], denominators_[k]);
    same = same && denominators_[k] == denominators_[count];
  }
  if (!same) {
    common_ = denominators_[count];
    for (std::size_t k = 0; k < count; ++k)
      mpz_lcm(common_.get_mpz_t(), common_.get_mpz_t(), denominators_[k].get_mpz_t());
    for (std::size_t k = 0; k <= count; ++k) {
      mpz_divexact(t0_.get_mpz_t(), common_.get_mpz_t(), denominators_[k].get_mpz_t());
      for (std::size_t i = 0; i < D; ++i) mul(points_[k][i], points_[k][i], t0_);
    }
  } else {
    common_ = denominators_[count];
  }
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < D; ++i)
      mpz_sub(rows_[k][i].get_mpz_t(), points_[k][i].get_mpz_t(), points_[count][i].get_mpz_t());
}

template <int D>
void ExactPredicates<D>::determinant3(const Row& a, const Row& b, const Row& c, mpz_class& result) {
  if constexpr (D == 3) {
    mul(t0_, b[1], c[2]);
    submul(t0_, b[2], c[1]);
    mul(result, a[0], t0_);
    mul(t0_, b[0], c[2]);
    submul(t0_, b[2], c[0]);
    submul(result, a[1], t0_);
    mul(t0_, b[0], c[1]);
    submul(t0_, b[1], c[0]);
    addmul(result, a[2], t0_);
  }
}

template <int D>
void ExactPredicates<D>::squared_length(const Row& a, mpz_class& result) {
  result = 0;
  for (std::size_t i = 0; i < D; ++i) {
    t0_ = 0;
    for (std::size_t j = 0; j < D; ++j)
      if (sgn(metric_->gram[i][j]) != 0) addmul(t0_, metric_->gram[i][j], a[j]);
    addmul(result, t0_, a[i]);
  }
}

template <int D>
Sign ExactPredicates<D>::orientation(const std::array<OrbitPoint, D + 1>& p) {
  load_differences(p.data() + 1, D, p[0]);
  if constexpr (D == 2) {
    mul(det_, rows_[0][0], rows_[1][1]);
    submul(det_, rows_[0][1], rows_[1][0]);
  } else {
    determinant3(rows_[0], rows_[1], rows_[2], det_);
  }
  return sign_of(det_);
}

template <int D>
Sign ExactPredicates<D>::insphere(const std::array<OrbitPoint, D + 1>& p, const OrbitPoint& w) {
  load_differences(p.data(), D + 1, w);
  for (std::size_t k = 0; k <= D; ++k) squared_length(rows_[k], lengths_[k]);
  const auto minor = [this](std::size_t r, std::size_t s, mpz_class& result) {
    mul(result, rows_[r][0], rows_[s][1]);
    submul(result, rows_[r][1], rows_[s][0]);
  };
  if constexpr (D == 2) {
    minor(1, 2, t0_);
    mul(det_, t0_, lengths_[0]);
    minor(0, 2, t0_);
    submul(det_, t0_, lengths_[1]);
    minor(0, 1, t0_);
    addmul(det_, t0_, lengths_[2]);
    return sign_of(det_);
  } else {
    const auto cominor = [this](std::size_t r, std::size_t s, mpz_class& result) {
      mul(result, rows_[r][2], lengths_[s]);
      submul(result, rows_[s][2], lengths_[r]);
    };
    // Laplace expansion along columns (x, y), (z, |.|^2).
    constexpr std::array<std::array<std::size_t, 4>, 6> kPairs{
        {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
    constexpr std::array<bool, 6> kNegative{false, true, false, false, true, false};
    det_ = 0;
    for (std::size_t k = 0; k < 6; ++k) {
      minor(kPairs[k][0], kPairs[k][1], t0_);
      cominor(kPairs[k][2], kPairs[k][3], t1_);
      if (kNegative[k])
        submul(det_, t0_, t1_);
      else
        addmul(det_, t0_, t1_);
    }
    return -sign_of(det_);
  }
}

template <int D>
std::pair<Integer, Integer> ExactPredicates<D>::squared_circumradius(const std::array<OrbitPoint, D + 1>& p) {
  load_differences(p.data() + 1, D, p[0]);
  for (std::size_t k = 0; k < D; ++k) squared_length(rows_[k], lengths_[k]);
  // y = adj(A) q and det(A), A the matrix of rows_; everything scaled: rows by common_, lengths by common_^2
  // * gram denominator.
  std::array<mpz_class, D> y;
  if constexpr (D == 2) {
    mul(det_, rows_[0][0], rows_[1][1]);
    submul(det_, rows_[0][1], rows_[1][0]);
    mul(y[0], rows_[1][1], lengths_[0]);
    submul(y[0], rows_[0][1], lengths_[1]);
    mul(y[1], rows_[0][0], lengths_[1]);
    submul(y[1], rows_[1][0], lengths_[0]);
  } else {
    det_ = 0;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const Row &u = rows_[(k + 1) % 3], &v = rows_[(k + 2) % 3];
        const std::size_t r = (i + 1) % 3, s = (i + 2) % 3;
        mul(t0_, u[r], v[s]);
        submul(t0_, u[s], v[r]);
        addmul(y[i], t0_, lengths_[k]);
        if (k == 0) addmul(det_, t0_, rows_[0][i]);
      }
  }
  ensure(sgn(det_) != 0, "a cell is not flat");
  mpz_class numerator = 0;
  for (std::size_t i = 0; i < D; ++i) {
    t1_ = 0;
    for (std::size_t j = 0; j < D; ++j) addmul(t1_, metric_->adjoint[i][j], y[j]);
    addmul(numerator, t1_, y[i]);
  }
  // With unscaled A = A'/m, q = q'/(m^2 g), G = G'/g (m common, g Gram denominator): y = y'/(m^(D+1) g),
  // adj(G) = adj(G')/g^(D-1), det(A) = det(A')/m^D, det(G) = det(G')/g^D. So
  // R^2 = [y'^T adj(G') y' / (4 det(A')^2 det(G'))] / (m^2 g).
  mpz_class denominator = det_ * det_;
  denominator *= metric_->determinant;
  denominator *= 4;
  denominator *= common_;
  denominator *= common_;
  denominator *= metric_->denominator;
  return {Integer(numerator), Integer(denominator)};
}

template struct IntegralMetric<2>;
template struct IntegralMetric<3>;
template class ExactPredicates<2>;
template class ExactPredicates<3>;

}  // namespace flatdt::ref
