#include "group_translations.hpp"

namespace flatdt::ref {
namespace {

void merge(HermiteBasis& into, const HermiteBasis& from) {
  for (const Vector& v : from.vectors()) into.add(v);
}

}  // namespace

void TranslationSum::add(const Vector& translation) {
  if (translation.is_zero()) return;
  // Most generators of most groups repeat what is known.
  for (const auto& sum : partial_)
    if (sum && sum->contains(translation)) return;
  HermiteBasis carry(dimension_);
  carry.add(translation);
  for (auto& sum : partial_) {
    if (!sum) {
      sum = carry;
      return;
    }
    merge(carry, *sum);
    sum.reset();
  }
  partial_.emplace_back(carry);
}

HermiteBasis TranslationSum::total() const {
  HermiteBasis all(dimension_);
  for (const auto& sum : partial_)
    if (sum) merge(all, *sum);
  return all;
}

}  // namespace flatdt::ref
