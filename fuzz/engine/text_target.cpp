/// The parts of a target whose inputs are texts already: its files are the bytes themselves. Engines mutate
/// them byte by byte, helped by the target's dictionary.
#include <algorithm>

#include "target.hpp"

namespace flatdt::fuzz {

std::vector<File> print(std::span<const std::uint8_t> bytes) {
  return {{"txt", std::string(bytes.begin(), bytes.end())}};
}

std::optional<Bytes> encode(const std::vector<std::string>& texts) {
  if (texts.size() != 1) return std::nullopt;
  return Bytes(texts[0].begin(), texts[0].end());
}

}  // namespace flatdt::fuzz
