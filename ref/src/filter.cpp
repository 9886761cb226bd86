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
}

template class Filter<2>;
template class Filter<3>;

}  // namespace flatdt::ref
