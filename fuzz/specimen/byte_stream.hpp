/// Bytes as a stream of small numbers and rationals. Reading is total: every byte string means something, and
/// after its end come zeros.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flatdt/ref/isometry.hpp"

namespace flatdt::fuzz {

class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] std::uint8_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : std::uint8_t{0}; }
  [[nodiscard]] int below(int bound) { return byte() % bound; }
  /// A rational with a numerator of 64 bits and a denominator from 1 to 2^63 - 1.
  [[nodiscard]] ref::Rational rational();
  [[nodiscard]] ref::Vector vector(int dimension);
  [[nodiscard]] ref::Matrix matrix(int dimension);
  [[nodiscard]] ref::Isometry isometry(int dimension);

 private:
  [[nodiscard]] std::uint64_t unsigned_of(int length);

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// The inverse of ByteReader.
class ByteWriter {
 public:
  void byte(int value) { bytes_.push_back(static_cast<std::uint8_t>(value)); }
  void rational(const ref::Rational& value);
  void vector(const ref::Vector& v);
  void matrix(const ref::Matrix& m);
  void isometry(const ref::Isometry& g);
  /// Whether all rationals written had numerators and denominators within 63 bits.
  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  bool fits_ = true;
};

}  // namespace flatdt::fuzz
