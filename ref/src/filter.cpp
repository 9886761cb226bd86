#include "flatdt/ref/filter.hpp"

namespace flatdt::ref {

template <int D>
Filter<D>::Filter(const Frame& frame, int row_sum) : row_sum_(row_sum) {
  // Scale by a power of two so that the largest entry lies in (1/2, 2): exact, and no overflow in double.
  Rational largest;
  for (int i = 0; i < D; ++i)
    if (frame.gram(i, i) > largest) largest = frame.gram(i, i);
  long exponent = 0;
  const auto exponent_of = [](const Rational& value) {
    long numerator_exponent = 0, denominator_exponent = 0;
    mpz_get_d_2exp(&numerator_exponent, value.mpq().get_num_mpz_t());
    mpz_get_d_2exp(&denominator_exponent, value.mpq().get_den_mpz_t());
    return numerator_exponent - denominator_exponent;
  };
  exponent = exponent_of(largest);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      const Rational& entry = frame.gram(i, j);
      if (entry.is_zero()) continue;
      if (exponent_of(entry) - exponent < -400) {
        enabled_ = false;
        continue;
      }
      mpq_class scaled = entry.mpq();
      if (exponent >= 0)
        mpq_div_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
      else
        mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
      gram_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = scaled.get_d();
    }
  if constexpr (D == 2) {
    const double det = gram_[0][0] * gram_[1][1] - gram_[0][1] * gram_[1][0];
    inverse_gram_[0] = {gram_[1][1] / det, -gram_[0][1] / det, 0};
    inverse_gram_[1] = {-gram_[1][0] / det, gram_[0][0] / det, 0};
  } else {
    const auto cofactor = [this](std::size_t i, std::size_t j) {
      const std::size_t r = (i + 1) % 3, s = (i + 2) % 3, t = (j + 1) % 3, u = (j + 2) % 3;
      return gram_[r][t] * gram_[s][u] - gram_[r][u] * gram_[s][t];
    };
    double det = 0;
    for (std::size_t j = 0; j < 3; ++j) det += gram_[0][j] * cofactor(0, j);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) inverse_gram_[i][j] = cofactor(j, i) / det;
  }
}

template class Filter<2>;
template class Filter<3>;

}  // namespace flatdt::ref
