/// What every fuzz target offers beside LLVMFuzzerTestOneInput: its inputs as files that the programs read,
/// and the way back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace flatdt::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// A file that an input means: NAME.extension.
struct File {
  std::string extension;
  std::string text;
};

/// The files that the bytes mean, the instance before its triangulation.
std::vector<File> print(std::span<const std::uint8_t> bytes);

/// Bytes that mean these texts; nothing if they are beyond the limits of the target's decoder.
/// Law: print(encode(texts)) are the same instance and triangulation, though perhaps written otherwise.
std::optional<Bytes> encode(const std::vector<std::string>& texts);

}  // namespace flatdt::fuzz

extern "C" {
// The entry points that libFuzzer documents; AFL++ and honggfuzz call the first one too.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned int seed);
std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1, const std::uint8_t* data2,
                                      std::size_t size2, std::uint8_t* out, std::size_t max_out_size,
                                      unsigned int seed);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
}
