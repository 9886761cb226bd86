/// A rational is a byte whose halves are the lengths of numerator and denominator, then these, the least
/// byte first, the numerator in two's complement. Length 0 means 0 for the numerator and 1 for the
/// denominator.
#include "byte_stream.hpp"

namespace flatdt::fuzz {
namespace {

constexpr int kLengths = 9;  // 0 to 8 bytes

/// The least number of bytes that hold the value in two's complement.
int length_of(std::int64_t value) {
  int length = 0;
  while (length < 8 && value != 0) {
    const std::int64_t rest = value >> (8 * length);
    if (length > 0 && (rest == 0 || rest == -1) && ((value >> (8 * length - 1)) & 1) == (rest & 1))
      return length;
    ++length;
  }
  return length;
}

}  // namespace

std::uint64_t ByteReader::unsigned_of(int length) {
  std::uint64_t value = 0;
  for (int k = 0; k < length; ++k) value |= std::uint64_t{byte()} << (8 * k);
  return value;
}

ref::Rational ByteReader::rational() {
  const int lengths = byte();
  const int above = (lengths & 15) % kLengths;
  const int below = (lengths >> 4) % kLengths;
  std::uint64_t bits = unsigned_of(above);
  if (above > 0 && above < 8 && (bits >> (8 * above - 1)) != 0) bits |= ~std::uint64_t{0} << (8 * above);
  const std::uint64_t denominator = unsigned_of(below) & (~std::uint64_t{0} >> 1);
  return {ref::Integer(static_cast<long>(bits)), ref::Integer(denominator == 0 ? 1UL : denominator)};
}

ref::Vector ByteReader::vector(int dimension) {
  ref::Vector v(dimension);
  for (int i = 0; i < dimension; ++i) v[i] = rational();
  return v;
}

ref::Matrix ByteReader::matrix(int dimension) {
  ref::Matrix m(dimension);
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j) m(i, j) = rational();
  return m;
}

ref::Isometry ByteReader::isometry(int dimension) {
  ref::Matrix linear = matrix(dimension);
  return {std::move(linear), vector(dimension)};
}

void ByteWriter::rational(const ref::Rational& value) {
  const ref::Integer numerator = value.numerator();
  const ref::Integer denominator = value.denominator();
  if (!numerator.fits_long() || !denominator.fits_long()) {
    fits_ = false;
    return;
  }
  const std::int64_t above = numerator.to_long();
  const std::int64_t below = denominator.to_long();
  const int above_length = length_of(above);
  const int below_length = below == 1 ? 0 : length_of(below);
  byte(above_length | (below_length << 4));
  for (int k = 0; k < above_length; ++k) byte(static_cast<int>((above >> (8 * k)) & 255));
  for (int k = 0; k < below_length; ++k) byte(static_cast<int>((below >> (8 * k)) & 255));
}

void ByteWriter::vector(const ref::Vector& v) {
  for (int i = 0; i < v.dimension(); ++i) rational(v[i]);
}

void ByteWriter::matrix(const ref::Matrix& m) {
  for (int i = 0; i < m.dimension(); ++i)
    for (int j = 0; j < m.dimension(); ++j) rational(m(i, j));
}

void ByteWriter::isometry(const ref::Isometry& g) {
  matrix(g.linear);
  vector(g.translation);
}

}  // namespace flatdt::fuzz
