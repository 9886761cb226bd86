#include "volume_sum.hpp"

namespace flatdt::checker {

void VolumeSum::add(const Integer& numerator, const Integer& denominator) {
  if (last_ == terms_.size() || terms_[last_].denominator != denominator) {
    const auto [position, inserted] = by_denominator_.try_emplace(denominator, terms_.size());
    if (inserted) terms_.push_back({0, denominator});
    last_ = position->second;
  }
  terms_[last_].numerator += abs(numerator);
}

void VolumeSum::add(const VolumeSum& other) {
  fixed_ = fixed_ + other.fixed_;
  for (const Term& term : other.terms_) add(term.numerator, term.denominator);
}

Rational VolumeSum::total() const {
  std::vector<Rational> sums;
  sums.emplace_back(to_integer(fixed_), fixed_denominator_);
  sums.back().canonicalize();
  for (const Term& term : terms_) {
    sums.emplace_back(term.numerator, term.denominator);
    sums.back().canonicalize();
  }
  for (; sums.size() > 1; sums.resize((sums.size() + 1) / 2)) {
    for (std::size_t i = 0; 2 * i < sums.size(); ++i) {
      if (2 * i + 1 < sums.size()) {
        sums[i] = sums[2 * i] + sums[2 * i + 1];
      } else {
        sums[i] = sums[2 * i];
      }
    }
  }
  return sums.front();
}

}  // namespace flatdt::checker
