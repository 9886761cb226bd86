// The exact sum of the volumes of cells.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "flatdt/checker/exact.hpp"
#include "wide.hpp"

namespace flatdt::checker {

/// Adds fractions of equal denominator first and then in a balanced tree, so that the work is quasi-linear in
/// the bits even when all denominators differ; a running sum would be quadratic. The tree keeps the order of
/// arrival: cells that are neighbours in the file often share vertices, and then their denominators share
/// factors.
class VolumeSum {
 public:
  /// `fixed_denominator`: of all numbers that come in fixed width.
  explicit VolumeSum(Integer fixed_denominator) : fixed_denominator_(std::move(fixed_denominator)) {}

  /// Adds |numerator| / denominator.   Requires: denominator > 0.
  void add(const Integer& numerator, const Integer& denominator);
  /// Adds |numerator| / fixed_denominator.   Requires: fewer than 2^60 calls.
  void add(const Wide<3>& numerator) { fixed_ = fixed_ + magnitude(numerator).widened<4>(); }
  /// Adds another sum with the same denominator for numbers of fixed width.
  void add(const VolumeSum& other);

  [[nodiscard]] Rational total() const;

 private:
  struct Term {
    Integer numerator;
    Integer denominator;
  };
  Integer fixed_denominator_;
  Wide<4> fixed_;
  std::vector<Term> terms_;
  std::map<Integer, std::size_t> by_denominator_;
  std::size_t last_ = 0;
};

}  // namespace flatdt::checker
