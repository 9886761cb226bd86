#include "scene_text.hpp"

#include <array>
#include <charconv>

#include "flatdt/ref/errors.hpp"

namespace flatdt::ref {

std::string decimal_text(double value, int digits) {
  std::array<char, 64> buffer{};
  const double plain = value == 0 ? 0.0 : value;  // no "-0"
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), plain, std::chars_format::general, digits);
  ensure(error == std::errc{}, "a number has at most 64 characters");
  return {buffer.data(), end};
}

std::string json_string(std::string_view plain) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "\"";
  for (const char c : plain) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      text += std::string("\\") + c;
    else if (byte < ' ' || byte > '~' || c == '<' || c == '>' || c == '&')
      text += std::string("\\u00") + kDigits[byte >> 4U] + kDigits[byte & 15U];
    else
      text += c;
  }
  return text + "\"";
}

}  // namespace flatdt::ref
