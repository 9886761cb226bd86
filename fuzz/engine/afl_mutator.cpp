/// The moves for AFL++, which knows nothing of libFuzzer's hooks: a library for AFL_CUSTOM_MUTATOR_LIBRARY.
/// Source: AFL++, "Custom Mutators" (afl_custom_init, afl_custom_fuzz, afl_custom_deinit).
#include <algorithm>
#include <new>

#include "target.hpp"

namespace {

struct State {
  std::uint64_t counter = 0;
  flatdt::fuzz::Bytes output;
};

}  // namespace

extern "C" {

void* afl_custom_init(void*, unsigned int seed) {
  return new (std::nothrow) State{seed, {}};
}

void afl_custom_deinit(void* data) {
  delete static_cast<State*>(data);
}

/// Every eighth output is a crossing with the other input that AFL++ offers.
std::size_t afl_custom_fuzz(void* data, std::uint8_t* input, std::size_t size, std::uint8_t** output,
                            std::uint8_t* other, std::size_t other_size, std::size_t max_size) {
  auto* state = static_cast<State*>(data);
  const auto seed = static_cast<unsigned>(++state->counter * 2654435761U);
  state->output.resize(std::max(max_size, size));
  std::size_t written = 0;
  if (other != nullptr && other_size > 0 && state->counter % 8 == 0) {
    written = LLVMFuzzerCustomCrossOver(input, size, other, other_size, state->output.data(), max_size, seed);
  } else {
    const std::size_t used = std::min(size, max_size);
    std::copy_n(input, used, state->output.begin());
    written = LLVMFuzzerCustomMutator(state->output.data(), used, max_size, seed);
  }
  *output = state->output.data();
  return written;
}
}
