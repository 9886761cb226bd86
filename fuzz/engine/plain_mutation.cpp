/// A stand-in for libFuzzer's own mutation of bytes, where another engine or none is linked: changes, removes
/// or inserts one byte. Deterministic, with a state of its own.
#include <algorithm>

#include "target.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size) {
  static std::uint64_t state = 1;
  const auto below = [](std::size_t n) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(state >> 33) % n;
  };
  if (max_size == 0) return 0;
  const std::size_t at = below(size + 1);
  const std::size_t kind = below(3);
  if (kind == 0 && size < max_size) {
    std::copy_backward(data + at, data + size, data + size + 1);
    data[at] = static_cast<std::uint8_t>(below(256));
    return size + 1;
  }
  if (at == size) return size;
  if (kind == 1) {
    std::copy(data + at + 1, data + size, data + at);
    return size - 1;
  }
  data[at] = static_cast<std::uint8_t>(below(256));
  return size;
}
