/// libFuzzer's hooks for targets whose inputs are specimens: decode, move, encode. One mutation in four is
/// libFuzzer's own, on the bytes, so that nothing that bytes can mean is out of reach.
#include <algorithm>

#include "../engine/target.hpp"
#include "../specimen/structured_target.hpp"
#include "moves.hpp"

namespace {

using flatdt::fuzz::Random;
using flatdt::fuzz::Specimen;

constexpr int kTries = 4;

/// Writes the specimen's bytes to data; 0 if they do not fit.
std::size_t write(const Specimen& specimen, std::uint8_t* data, std::size_t max_size) {
  const auto bytes = flatdt::fuzz::encode(specimen, flatdt::fuzz::kShape);
  if (!bytes || bytes->size() > max_size) return 0;
  std::copy(bytes->begin(), bytes->end(), data);
  return bytes->size();
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned int seed) {
  Random random(seed);
  if (random.one_in(4)) return LLVMFuzzerMutate(data, size, max_size);
  const Specimen original = flatdt::fuzz::decode({data, size}, flatdt::fuzz::kShape);
  for (int attempt = 0; attempt < kTries; ++attempt) {
    Specimen specimen = original;
    bool moved = true;
    for (int moves = 1 + random.below(3); moves > 0 && moved; --moves)
      moved = flatdt::fuzz::move_anything(specimen, random, flatdt::fuzz::kShape);
    if (!moved) continue;
    if (const std::size_t written = write(specimen, data, max_size)) return written;
  }
  return LLVMFuzzerMutate(data, size, max_size);
}

std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1, const std::uint8_t* data2,
                                      std::size_t size2, std::uint8_t* out, std::size_t max_out_size,
                                      unsigned int seed) {
  Random random(seed);
  Specimen specimen = flatdt::fuzz::decode({data1, size1}, flatdt::fuzz::kShape);
  const Specimen other = flatdt::fuzz::decode({data2, size2}, flatdt::fuzz::kShape);
  if (flatdt::fuzz::cross(specimen, other, random, flatdt::fuzz::kShape))
    if (const std::size_t written = write(specimen, out, max_out_size)) return written;
  const std::size_t size = std::min(size1, max_out_size);
  std::copy_n(data1, size, out);
  return size;
}
