/// The mutator of targets that have none of their own, for the standalone runner.
#include <algorithm>

#include "target.hpp"

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned int seed) {
  for (unsigned steps = 1 + seed % 8; steps > 0; --steps) size = LLVMFuzzerMutate(data, size, max_size);
  return size;
}

std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1, const std::uint8_t* data2,
                                      std::size_t size2, std::uint8_t* out, std::size_t max_out_size,
                                      unsigned int seed) {
  const std::size_t head = size1 == 0 ? 0 : std::min(seed % size1, max_out_size);
  const std::size_t tail = std::min(size2 == 0 ? 0 : size2 - seed % size2, max_out_size - head);
  std::copy_n(data1, head, out);
  std::copy_n(data2 + (size2 - tail), tail, out + head);
  return head + tail;
}
